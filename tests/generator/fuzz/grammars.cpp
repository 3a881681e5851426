// The rules. NOTE: sizes are small, so that one text takes less than a second.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/generator/fuzz/grammars.hpp"

#include <string>

namespace hvi::gen::fuzz {

namespace {

const std::string common = R"(
number: 1 | 1/2 | 2 | 0 | -1 | 3/4 | 0.1 | <digit>/<digit> | <digit><digit> | <constant> | <long>
constant: pi | e | sqrt(2) | sqrt(<digit>) | pi/<digit> | <function>(<number>)
    | (<number>)^(<exponent>) | <number>+<number> | <number>*<number> | (<number>)/(<number>)
long: 1.0015851063790825241 | 0.33333333333333333333333333333333333333 | 1e-30 | 1e300
    | 12345678901234567890123 | 1/10000000000000000000000001
exponent: 2 | 3 | 1/2 | 1/3 | -1 | <digit> | -<digit>/<digit>
function: sin | cos | exp | log | sqrt | tan | sinh | cosh | tanh | asin | acos | atan | log10 | cbrt
    | asinh | acosh | atanh | erf | erfc | abs | sign
digit: 1 | 2 | 3 | 4 | 5 | 6 | 7 | 8 | 9
$name: <name>
name: w | mu | a_1 | alpha | <awkward>
awkward: M_PI | NAN | INFINITY | HUGE_VAL | EOF | errno | assert | NULL | linux | unix | class | int
    | std | hvi | b | c | k | m | n | x | I | N | k1 | step | energy | State | S_ | stdout | offsetof
    | e | t | h | tau
named: midpoint | stormer-verlet | symplectic-euler | adjoint-symplectic-euler | trig3
    | <family>:1 | <family>:2 | <family>:3
family: gauss | lobatto | radau-left | radau-right | newton-cotes | newton-cotes-open | chebyshev
    | clenshaw-curtis | fejer
composition: yoshida:4 | suzuki:4 | blanes-moan:6 | yoshida:6 | kahan-li:8
)";

}  // namespace

const Grammar& command_lines() {
    static const Grammar grammar(R"(
line: <command><options>
command: tableau | check | stepper | scheme | run | report | list | completions | manual | module
    | --help | --version | <word>
options: _ | ~<option><options> | ~<option>~<option><options>
option: --method~<named> | --method=<named> | <key>~<value> | <key>=<value> | <flag>
    | <scene> | <word>
key: --method | --basis | --nodes | --weights | --method-file | --param | --format | --digits
    | -o | --output | --tableau | --max-order | --plot | --hamiltonian | --coordinates | --momenta
    | --solver | --lanes | --compose | --accuracy | --until | --name | --step | --only | --methods
    | --steps | --times | --checkpoint | --language
flag: --separable | --energy | --invariants | --evaluations | --dense | --action | --float128
    | --explain
    | --generating | --peers | --edges | --tangent | --help | --version | -h | -- | - | -o | --method
scene: kepler | pendulum | keplr | qp | SCENE | bash
value: <number> | <word> | <named> | json | text | latex | markdown | csv | auto | newton | stages
    | ensemble | gpu | none | <composition> | 1e-6 | 0.5 | work,stiff | html, json | gauss:2, trig3 | q, p
    | <$name>=<number> | 1, cos(pi*tau) | 0, 1 | p^2/2 + q^2/2 | 99999999999999999999 | -1
word: "" | x | -x | --x | --x=1 | = | --method= | é | %s | \ | ' | a b | tablaeu
    | <number> | <name>
)" + common);
    return grammar;
}

const Grammar& methods() {
    static const Grammar grammar(R"(
text: tableau~<method>~--format~<format><digits> | check~<method>~--max-order~<order><of_check>
    | stepper~<method><separable><compose><class>
digits: _ | ~--digits~<digit>
of_check: _ | ~--format~json | ~--plot~PLOT
separable: _ | ~--separable
compose: _ | _ | ~--compose~<composition>
class: _ | ~--name~<name>
parameter: _ | ~--param~<$name>=<number>
format: json | csv | latex | markdown | text
order: 2 | 3 | 4
method: --basis~<one>~--nodes~<node> | --basis~<two>~--nodes~<two_nodes>
    | --basis~<three>~--nodes~<three_nodes> | --method~<named>
    | --basis~<with_parameter>~--nodes~<three_nodes><parameter>
    | --basis~<two>~--nodes~0, <$name><parameter>
    | --basis~<one>~--nodes~<three_nodes> | --basis~<two>~--nodes~<three_nodes>
    | --basis~<two>~--nodes~<three_nodes>~--weights~<weights>
    | --basis~<three>~--nodes~<family>:6
with_parameter: 1, cos(<$name>*tau), sin(<$name>*tau) | 1, tau, <function>(<$name>*tau)
    | 1, exp(<$name>*tau), <function_of_tau> | 1, tau^<$name>, tau
one: 1 | <function_of_tau>
two: 1, <function_of_tau> | <function_of_tau>, <function_of_tau> | monomials:2 | trig:2
    | exp(<inner>), exp(-<inner>)
three: 1, <function_of_tau>, <function_of_tau> | 1, tau, <function_of_tau> | monomials:3 | trig:3
    | 1, tau, 1+tau
    | 1, cos(<inner>), sin(<inner>) | 1, <power>, <power>
    | bspline(<degree>,0), bspline(<degree>,1), bspline(<degree>,2)
degree: 2 | 1 | 0 | 3
node: 1/2 | 0 | 1 | 1/3 | <digit>/<digit> | <number> | gauss:1
weights: 1/6, 2/3, 1/6 | w, 1-2*w, w | 1/4, 1/2, 1/4 | 1/2, 0, 1/2 | <node>, <node>, <node>
two_nodes: 0, 1 | 0, <node> | <node>, 1 | <family>:2 | roots(<polynomial>) | <node>, <node>
three_nodes: 0, 1/2, 1 | 0, <node>, 1 | <family>:3 | <node>, <node>, <node> | 0, roots(<polynomial>)
polynomial: 6*tau^2-6*tau+1 | <factor>*<factor> | tau^3-<factor>
factor: (<digit>*tau-<digit>) | (tau-<number>) | (tau^2-<digit>/<digit>)
function_of_tau: tau | <power> | <function>(<inner>) | <number>*<function_of_tau>
    | tau*<function>(<inner>) | <factor>*<factor> | <function_of_tau>+<function_of_tau>
    | <function_of_tau>*<function_of_tau> | 1/<factor> | 1/(<digit>+tau^2) | <number>
power: tau^2 | tau^(<exponent>) | (1-tau)^(<exponent>) | sqrt(tau)
inner: tau | <digit>*tau | pi*tau | -tau/2 | (3/2)*pi*tau | <number>*tau | <number> | <factor>
)" + common);
    return grammar;
}

const Grammar& scenes() {
    static const Grammar grammar(R"(
text: stepper~FILE<options><class>~~<scene> | run~FILE<method><solver>~~<scene>
    | scheme~FILE~--method~<named><equations>~~<scene>
    | stepper~FILE~<rule><options><class>~~<scene>
    | stepper~<hamiltonian>~--method~<named><options><class>
equations: _ | ~--series~<digit> | ~--lagrangian | ~--generating
rule: --basis~1, tau~--nodes~0, 1/2, 1 | --basis~1~--nodes~0, 1 | --basis~1, tau~--nodes~gauss:4
options: <energy><invariants><dense><action><evaluations><float128><solver><lanes><compose>
energy: _ | ~--energy
invariants: _ | ~--invariants
dense: _ | _ | ~--dense
action: _ | _ | ~--action
evaluations: _ | ~--evaluations
float128: _ | _ | ~--float128
method: _ | ~--method~<named>
solver: _ | _ | ~--solver~newton | ~--solver~fixed-point | ~--solver~newton-taylor
lanes: _ | _ | ~--lanes~stages | ~--lanes~ensemble | ~--lanes~gpu | ~--lanes~none
compose: _ | _ | _ | ~--compose~<composition>
class: _ | _ | ~--name~<name>
hamiltonian: --hamiltonian~<h>+<$name>*q~--param~<$name>=<number>
scene: <head><one> | <head><two> | <head><many>
head: _ | description = "<words>"~ | name = "<name>"~
words: a pendulum | ends in a \\ | // | */ and /* | %s {} | @name@ | \"quoted\" | \\u000a \\n
one: coordinates = "q"~momenta = "p"~hamiltonian = "<h>"~<parameters><invariant><start>
invariant: [invariants]~<$kept> = "<u>"~
start: [initial]~q = <value>~p = <value>~<run>
two: coordinates = ["x", "y"]~momenta = ["px", "py"]~hamiltonian = "<h_of_two>"~<parameters><starts>
starts: [initial]~x = <value>~y = <value>~px = <value>~py = <value>~<run>
many: coordinates = "q[1..N]"~momenta = "p[1..N]"~hamiltonian = "<h_of_many>"~<size><defined><rules>
size: [parameters]~N = <digit>~<$name> = <constant_value>~<$name>2 = "<$name>/N"~
defined: [definitions]~"d[i]" = "<d>"~
rules: [initial]~"q[i]" = "i/<digit>"~"p[i]" = <value>~<run>
h_of_many: sum(i=1..N, p[i]^2)/2 + <u_of_many> | sum(i=1..N, p[i]^2/2 + q[i]^<exponent>)
u_of_many: sum(i=1..N, d[i]^2) | sum(i=1..N-1, j=i+1..N, (q[i]-q[j])^2) | sum(i=1..N, <function>(d[i]))
    | sum(i=1..N, q[mod(i,N)+1]*q[i]) | sum(i=1..N+1, q[i]) | q[<digit>] | <$name>2*sum(i=2..N, q[i-1])
d: q[i] | q[mod(i,N)+1]-q[i] | <number>*q[i] | sum(j=1..N, q[j]*i)
parameters: [parameters]~<$name> = <constant_value>~
constant_value: 1 | "1/2" | 0.25 | "<number>"
run: [run]~method = "<named>"~step = <value>~until = <value>~
$kept: kept | <awkward>
value: 1 | "1/2" | 0.25 | "<number>" | "<$name>" | "<$name>*<number>"
h: p^2/2 + <u> | p^2/(2*<$name>) + <u> | <kinetic> + <u> | q*p | p^2/2 + q^2/2 | <u>*p | (p-<u>)^2/2
    | p^2/2 + t*<u>
kinetic: sqrt(1+p^2) | sqrt(p^2) | p^4/4 | <function>(p) | p^2*<number>
u: q^2 | -cos(q) | <$name>*q | q^<exponent> | <function>(<argument>) | <number>*<u> | <u>+<u>
    | <u>*<u> | <number>
argument: q | <$name>*q | q/q | q-q | q^2 | <u> | <number> | q*p
h_of_two: (px^2 + py^2)/2 + <u_of_two> | px*py + <u_of_two> | x*py - y*px | (px^2 + <number>*py^2)/2
    | (x*px + y*py)^2 + <u_of_two>
u_of_two: x^2 + y^2 | -<$name>/sqrt(x^2 + y^2) | x^2*y - y^3/3 | <function>(x - y)
    | <u_of_two>*<number>
)" + common);
    return grammar;
}

const Grammar& searches() {
    static const Grammar grammar(R"rules(
text: symmetries~FILE~~<scene> | check~FILE~--method~<named>~--max-order~2~~<scene>
    | run~FILE~~<scene> | symmetries~--hamiltonian~p1^2/2+p2^2/2+<u>
    | stepper~--method~gauss:2~--hamiltonian~p1^2/2+p2^2/2-<u>
    | stepper~--basis~1, tau~--nodes~0, 1/2, 1~--hamiltonian~<chosen>
scene: <families> | <lagrangian>
families: coordinates = "x[1..N]"~momenta = "p[1..N]"~hamiltonian = "sum(i=1..N, p[i]^2/2 + <e>)"~<own>
own: [functions]~V = {header = "V.hpp", arguments = 1}~<size>
size: [parameters]~N = <many>~<kept>"x[i]" = 1~"p[i]" = "0"~<run>
many: 80 | 3 | 200
kept: [initial]~ | [invariants]~kept = "sum(i=1..N, <e>)"~[initial]~
e: x[i]^2/2 | V(x[i]) | <number>*x[i] | <function>(<number>) | x[i]^<large> | <function>(x[i])
    | <e>+<e> | x[mod(i,N)+1] | <e>*x[i]
large: 2 | 10000 | <exponent>
lagrangian: coordinates = ["q1", "q2"]~velocities = ["v1", "v2"]~lagrangian = "v1^2/2+v2^2/2-<u>"~<value>
value: [parameters]~b = <digit>~[invariants]~kept = "<number>"~<start>
start: [initial]~q1 = 1~q2 = 1~v1 = 0~v2 = 0~<run>
run: [run]~method = "gauss:2"~step = 0.1~until = 1~
u: q1*q2/q2 | <function>(<choice>) | <choice> | <function>(q1/q1-<number>) | <number>*q1 | <u>+<u>
    | q1*<function>(q2)/<function>(q2) | <quotient>*q2
quotient: q1/q1 | (q1-<number>)/(q1-<number>) | q1^<exponent>/q1
choice: if(b>3,q2,q1) | if(<number>><number>,q2,q1) | min(q1,q2) | if(q1*q2>b,q1,<number>)
chosen: p^2/2+<of_one> | min(<of_p>,<of_one>) | <of_p>+if(<of_p>><number>,q,<of_one>)
of_p: p^2 | <function>(<function>(p)) | p*p
of_one: q | <function>(q) | if(p*p><number>,q,<function>(q)) | <number>*q
)rules" + common);
    return grammar;
}

const Grammar& tableau_files() {
    static const Grammar grammar(R"(
text: check~--tableau~FILE~--max-order~<order><options>~~{<tableau>}~
order: 3 | 2 | 4
options: _ | ~--format~json | ~--plot~PLOT | ~--format~json | ~--param~<$name>=<number>
tableau: "c": [<half>], "b": [<one>], "A": [[<half>]]
    | "c": [<entry>], "b": [<entry>], "A": [[<entry>]]
    | "c": [0, 1], "b": [<half>, <half>], "A": <trapezium>, "A_tilde": [[<half>, 0], [<half>, 0]]
    | "c": [<g1>, <g2>], "b": [<half>, <half>], "A": [[<quarter>, <a12>], [<a21>, <quarter>]]
    | "c": <pair>, "b": <pair>, "A": [<pair>, <pair>]
    | "c": [0, <half>, <half>, <one>], "b": [<sixth>, <third>, <third>, <sixth>], "A": <kutta>
trapezium: [[0, 0], [<half>, <half>]]
pair: [<entry>, <entry>]
kutta: [[0, 0, 0, 0], [<half>, 0, 0, 0], [0, <half>, 0, 0], [0, 0, <one>, 0]]
half: 0.5 | "1/2" | 0.5 | <entry>
one: 1 | 1.0 | "1" | 1 | <entry>
quarter: 0.25 | "1/4" | 0.25 | <entry>
sixth: 0.16666666666666666 | "1/6" | 0.166667 | <entry>
third: 0.3333333333333333 | "1/3" | 0.333333 | <entry>
g1: "1/2-sqrt(3)/6" | 0.21132486540518713 | 0.211325 | <entry>
g2: "1/2+sqrt(3)/6" | 0.78867513459481287 | 0.788675 | <entry>
a12: "1/4-sqrt(3)/6" | -0.038675134594812866 | -0.038675 | <entry>
a21: "1/4+sqrt(3)/6" | 0.53867513459481287 | 0.538675 | <entry>
entry: 0 | "<number>" | <digit>e-<digit> | "<$name>" | {"exact": null, "decimal": "0.<digit><digit>"}
    | -<digit>.<digit> | {"exact": "<number>", "decimal": null}
)" + common);
    return grammar;
}

}  // namespace hvi::gen::fuzz
