# A program in Julia: half an orbit of a planet.
# SPDX-License-Identifier: GPL-2.0-or-later
using Libdl

library = dlopen(ARGS[1])
call(name) = dlsym(library, name)

ecc, steps = 0.5, 400
planet = Ref{Ptr{Cvoid}}()
x = zeros(4)
@assert ccall(call(:kepler_create), Cint, (Ptr{Cdouble}, Csize_t, Ref{Ptr{Cvoid}}),
    [1.0, ecc], 2, planet) == 0
@assert ccall(call(:kepler_initial), Cint, (Ptr{Cvoid}, Ptr{Cdouble}), planet[], x) == 0
for _ in 1:steps
    @assert ccall(call(:kepler_step), Cint, (Ptr{Cvoid}, Ptr{Cdouble}, Cdouble),
        planet[], x, pi / steps) == 0
end
@assert abs(x[1] + 1 + ecc) < 1e-12
@assert ccall(call(:kepler_destroy), Cint, (Ptr{Cvoid},), planet[]) == 0
@assert ccall(call(:kepler_destroy), Cint, (Ptr{Cvoid},), planet[]) != 0
