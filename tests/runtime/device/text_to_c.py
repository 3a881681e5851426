#!/usr/bin/env python3
# Writes the kernels of a text for NVIDIA's cards, PTX, as functions in C, so that a test runs what a card
# would compute: each instruction is a statement, each register a variable.
# SPDX-License-Identifier: GPL-2.0-or-later
"""
text_to_c.py KERNELS.ptx > kernels.c

A kernel NAME becomes void NAME(void** arguments), where each argument is the address of a parameter, as
cudaLaunchKernel() has them. Instructions that are not known here end the program.
"""
import re
import sys

TYPES = {"f64": "double", "f32": "float"}
for bits in (8, 16, 32, 64):
    TYPES.update({f"u{bits}": f"uint{bits}_t", f"b{bits}": f"uint{bits}_t", f"s{bits}": f"int{bits}_t"})

ARITHMETIC = {"add": "+", "sub": "-", "mul": "*", "div": "/", "and": "&", "or": "|", "xor": "^",
              "shl": "<<", "shr": ">>"}
COMPARISONS = {"lt": "<", "le": "<=", "gt": ">", "ge": ">=", "eq": "==", "ne": "!=",
               "lo": "<", "ls": "<=", "hi": ">", "hs": ">="}
FUNCTIONS = {"sqrt": "sqrt", "fma": "fma", "abs": "fabs", "min": "fmin", "max": "fmax"}
# Where a rounding has to be written, or may be: sums are rounded to the nearest number in any case.
ROUNDED = {"mul", "div", "sqrt", "fma", "rcp"}


class Kernel:
    def __init__(self, name, parameters, body):
        self.parameters = re.findall(r"(\w+)(?:\[\d+\])?\s*(?:,|$)", parameters)
        self.arrays = dict(re.findall(r"\.local\s+[^;]*\.b8\s+(\w+)\[(\d+)\];", body))
        registers = re.findall(r"\.reg\s+\.(\w+)\s+%(\w+)(?:<(\d+)>)?;", body)
        self.lines = [f"void {name}(void** arguments) {{"]
        for kind, register, count in registers:
            of = "int" if kind == "pred" else "Register"
            self.lines.append(f"    static {of} {register}[{count or 1}];")
        self.lines += [f"    static uint8_t {array}[{size}];" for array, size in self.arrays.items()]
        body = re.sub(r"(?m)^\s*\.(reg|local)\s[^;]*;|^\s*\.pragma[^;]*;", "", body)
        for statement in body.split(";"):
            self.translate(statement)
        self.lines.append("}")

    # ---- operands ----

    def operand(self, text, kind):
        text = text.strip()
        if match := re.fullmatch(r"%(p)(\d+)", text):
            return f"p[{match[2]}]"
        if match := re.fullmatch(r"%([a-z]+)(\d+)", text):
            return f"{match[1]}[{match[2]}].{kind}"
        if match := re.fullmatch(r"%(SPL?)", text):
            return f"{match[1]}[0].{kind}"
        if match := re.fullmatch(r"0([df])([0-9A-Fa-f]+)", text):
            of = "f64" if match[1] == "d" else "f32"
            return f"((Register){{.u64 = 0x{match[2]}ULL}}).{of}"
        if text in self.parameters:
            return f"(uint64_t)arguments[{self.parameters.index(text)}]"
        if text in self.arrays:
            return f"(uint64_t){text}"
        if re.fullmatch(r"-?\d+", text):
            return text if kind == "pred" else f"(({TYPES[kind]}){text}LL)"
        raise SystemExit(f"what is the operand {text}?")

    def memory(self, address, kind, place=0):
        match = re.fullmatch(r"\[([%\w]+)(?:\+(-?\d+))?\]", address.strip())
        offset = int(match[2] or 0) + place * int(kind[1:]) // 8
        return f"*({TYPES[kind]}*)({self.operand(match[1], 'u64')} + {offset})"

    # ---- instructions ----

    def translate(self, statement):
        statement = statement.strip()
        while match := re.match(r"(?:(\$?\w+):|[{}])\s*", statement):
            if match[1]:
                self.lines.append(f"{match[1].replace('$', 'L')}:;")
            statement = statement[match.end():]
        if not statement:
            return
        guard, name, rest = re.fullmatch(r"(?:@(!?%p\d+)\s+)?([a-z][\w.:]*)\s*(.*)", statement,
                                         re.S).groups()
        parts = name.split(".")
        operands = [one.strip() for one in re.split(r",(?![^{]*\})", rest)] if rest else []
        code = self.code(parts, operands)
        if guard:
            code = f"if ({guard.replace('%p', 'p[')}]) {{ {code}; }}"
        self.lines.append(f"    {code};")

    def code(self, parts, operands):
        head, kind = parts[0], parts[-1]
        is_number = kind in ("f32", "f64")
        if head in ROUNDED and is_number and "rn" not in parts or "ftz" in parts:
            raise SystemExit(f"{'.'.join(parts)} rounds as it likes")
        if head == "bra":
            return f"goto {operands[0].replace('$', 'L')}"
        if head == "ret":
            return "return"
        if head in ("ld", "st"):
            return self.transfer(head, kind, operands)
        if head == "setp":
            return self.comparison(parts[1], kind, operands)
        if head == "cvt":
            to, of = [part for part in parts[1:] if part in TYPES]
            return f"{self.operand(operands[0], to)} = ({TYPES[to]}){self.operand(operands[1], of)}"
        if head == "mul" and "wide" in parts:
            wide = f"{kind[0]}{2 * int(kind[1:])}"
            a, b = (self.operand(each, kind) for each in operands[1:])
            return f"{self.operand(operands[0], wide)} = ({TYPES[wide]}){a} * ({TYPES[wide]}){b}"
        to, *of = (self.operand(each, kind) for each in operands)
        if head in ("shl", "shr"):
            of[1] = self.operand(operands[2], "u32")
        if head == "selp":
            return f"{to} = {self.operand(operands[3], 'pred')} ? {of[0]} : {of[1]}"
        return f"{to} = {self.value(head, kind, of)}"

    @staticmethod
    def value(head, kind, of):
        if head in ("mov", "cvta"):
            return of[0]
        if head in ARITHMETIC:
            return f"{of[0]} {ARITHMETIC[head]} {of[1]}" + (" & 1" if kind == "pred" else "")
        if head in ("neg", "not"):
            return {"neg": "-", "not": "!" if kind == "pred" else "~"}[head] + of[0]
        if head == "rcp":
            return f"1 / {of[0]}"
        if head in FUNCTIONS and kind in ("f32", "f64"):
            return f"{FUNCTIONS[head]}{'f' if kind == 'f32' else ''}({', '.join(of)})"
        if head in ("min", "max"):
            return f"{of[0]} {'<' if head == 'min' else '>'} {of[1]} ? {of[0]} : {of[1]}"
        raise SystemExit(f"what does {head}.{kind} do?")

    def transfer(self, head, kind, operands):
        values, address = operands if head == "ld" else reversed(operands)
        register = kind if int(kind[1:]) > 8 else kind[0] + "16"
        codes = []
        for place, value in enumerate(values.strip("{}").split(",")):
            to, of = self.operand(value, register), self.memory(address, kind, place)
            codes.append(f"{to} = {of}" if head == "ld" else f"{of} = {to}")
        return codes[0] if len(codes) == 1 else "{ " + "; ".join(codes) + "; }"

    def comparison(self, how, kind, operands):
        to = self.operand(operands[0], "pred")
        a, b = (self.operand(each, kind) for each in operands[1:])
        either_is_nan = f"({a} != {a} || {b} != {b})"
        if how in ("nan", "num"):
            return f"{to} = {'!' if how == 'num' else ''}{either_is_nan}"
        if kind in ("f32", "f64") and how.endswith("u") and how[:-1] in COMPARISONS:
            return f"{to} = {a} {COMPARISONS[how[:-1]]} {b} || {either_is_nan}"
        if kind in ("f32", "f64") and how == "ne":
            return f"{to} = {a} != {b} && !{either_is_nan}"
        return f"{to} = {a} {COMPARISONS[how]} {b}"


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        text = re.sub(r"//[^\n]*", "", file.read())
    print("#include <math.h>\n#include <stdint.h>\n")
    members = " ".join(f"{TYPES[kind]} {kind};" for kind in TYPES)
    print(f"typedef union {{ {members} }} Register;\n")
    for kernel in re.findall(r"\.visible\s+\.entry\s+(\w+)\s*\(([^)]*)\)[^{]*\{(.*?)\n\}", text, re.S):
        print("\n".join(Kernel(*kernel).lines) + "\n")


main()
