camera { location 0 direction 0 look_at z }
sphere { 0, 1 }
