sphere { 0, 1 }
wobble { 3 }
