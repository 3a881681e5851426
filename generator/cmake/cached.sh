#!/bin/sh
# Runs ccache with a call of the compiler: cached.sh CCACHE COMPILER WORD...
# SPDX-License-Identifier: GPL-2.0-or-later

# NOTE: where a precompiled header lies already, the preprocessor reads it in place of the headers that
# it is made of. To ccache, which asks the preprocessor, any change of these would look like none.
previous=
for word in "$@"; do
    case $previous$word in
        -o*.gch | -o*.pch) rm -f "$word" ;;
    esac
    previous=$word
done
exec "$@"
