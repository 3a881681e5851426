#!/bin/sh
# A compiler of CUDA for machines without a card: rows of a GPU become turns of a loop of the host.
# SPDX-License-Identifier: GPL-2.0-or-later
set -eu
if [ "$1" = --version ]; then
    echo "pretended nvcc"
    exit 0
fi
options=
while [ $# -gt 0 ]; do
    case $1 in
        -Xcompiler) ;;
        -x) shift ;;
        *) options="$options $1" ;;
    esac
    shift
done
# shellcheck disable=SC2086 # these are words
exec c++ $options
