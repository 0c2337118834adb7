#declare A = "never closed
