#!/bin/sh
# A compiler for what hvi-gen compiles: cached_compiler.sh OPTION... main.cpp -o program -lLIBRARY...
# ccache keeps nothing where a call links as well, so these are two.
# SPDX-License-Identifier: GPL-2.0-or-later
set -eu
case " $* " in
    *" main.cpp -o program "*) ;;
    *) exec c++ "$@" ;;
esac
options=
linking=
libraries=
for word in "$@"; do
    case $word in
        main.cpp | -o | program) ;;
        -shared) linking="$linking $word" ;;
        -l*) libraries="$libraries $word" ;;
        *) options="$options $word" ;;
    esac
done
# The headers beside it have just been written, and are new whenever they are the same.
export CCACHE_SLOPPINESS=include_file_mtime,include_file_ctime,time_macros
# shellcheck disable=SC2086 # these are words
ccache c++ $options -c main.cpp -o main.o
# shellcheck disable=SC2086
c++ $linking main.o -o program $libraries
rm main.o
