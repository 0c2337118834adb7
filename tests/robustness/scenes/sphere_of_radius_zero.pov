sphere { 0, 0 }
