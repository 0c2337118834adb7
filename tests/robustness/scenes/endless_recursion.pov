#macro F(N)
  F(N + 1)
#end
F(0)
