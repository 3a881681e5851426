// A scene in which the search for symmetries takes for ever.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace hvi::test {

/// Four atoms with bonds that are springs, and a torsion: an angle between two planes, whose
/// derivatives have some thousand terms.
inline const char* const torsion = R"toml(
name        = "torsion"
coordinates = ["x[1..4]", "y[1..4]", "z[1..4]"]
momenta     = ["u[1..4]", "v[1..4]", "w[1..4]"]
hamiltonian = "sum(i=1..4, u[i]^2+v[i]^2+w[i]^2)/2 + sum(i=1..3, (sqrt((x[i+1]-x[i])^2+(y[i+1]-y[i])^2+(z[i+1]-z[i])^2)-1)^2)/2 + k*(1+cos(3*phi))"

[definitions]
ax = "x[2]-x[1]"
ay = "y[2]-y[1]"
az = "z[2]-z[1]"
bx = "x[3]-x[2]"
by = "y[3]-y[2]"
bz = "z[3]-z[2]"
cx = "x[4]-x[3]"
cy = "y[4]-y[3]"
cz = "z[4]-z[3]"
mx = "ay*bz-az*by"
my = "az*bx-ax*bz"
mz = "ax*by-ay*bx"
nx = "by*cz-bz*cy"
ny = "bz*cx-bx*cz"
nz = "bx*cy-by*cx"
phi = "atan2(((my*nz-mz*ny)*bx+(mz*nx-mx*nz)*by+(mx*ny-my*nx)*bz)/sqrt(bx^2+by^2+bz^2), mx*nx+my*ny+mz*nz)"

[parameters]
k = "1/10"

[initial]
x = [0, 1, 1, "3/2"]
y = [0, 0, 1, 1]
z = [0, 0, 0, 1]
u = [0, 0, "1/10", 0]
v = ["1/10", 0, 0, 0]
w = [0, 0, "-1/10", 0]

[run]
method = "gauss:2"
step = "1/100"
until = 1

)toml";

}  // namespace hvi::test
