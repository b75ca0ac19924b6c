#!/usr/bin/env bash
# Checks many levels in shards with GNU parallel, on this machine or on several, and ends with the exit code of gq merge.
#   gnu-parallel.sh RUN SHARDS PATH...    RUN: a folder for plan, log and results; another plan in it is not replaced
#   gnu-parallel.sh RUN                   goes on with what is missing
# HOSTS=:,a.example.org,b.example.org also uses these machines, by ssh; `:` is this one. They need this folder at the same
# place, on a shared disk, with gq in its node_modules. JOBS is the number of shards at once per machine: one for each core
# if it is not set. GQ is the command, node_modules/.bin/gq if it is not set.
set -euo pipefail

gq=${GQ:-node_modules/.bin/gq}
run=${1:?expected a folder for the run}
shift
if [ $# -gt 0 ] || [ ! -e "$run/plan.json" ]; then
  shards=${1:?expected the number of shards: $run has no plan yet}
  shift
  mkdir -p "$run"
  "$gq" plan "$@" --shards "$shards" -o "$run/plan.json"
fi
mkdir -p "$run/out"

options=(--quote --joblog "$run/shards.log" --retries 3 --timeout 3600)
if [ -n "${JOBS:-}" ]; then options+=(--jobs "$JOBS"); fi
if [ -n "${HOSTS:-}" ]; then options+=(--sshlogin "$HOSTS" --workdir "$PWD"); fi

# the shards that have no result yet, one a line; if there is no answer, the merge below says why
missing=$("$gq" merge "$run/out" --plan "$run/plan.json" --missing list) || true
# a shard that fails does not end the others; merge names it
[ -z "$missing" ] || printf '%s\n' "$missing" |
  parallel "${options[@]}" "$gq" check --plan "$run/plan.json" --shard {} --out "$run/out" --jobs 1 || true
"$gq" merge "$run/out" --plan "$run/plan.json"
