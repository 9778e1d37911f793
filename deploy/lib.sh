# deploy/lib.sh: what the scripts of this folder share: messages, long steps with a log, where things are.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
log_dir=$root/build/log
jobs=$(nproc)

say() { printf '%s\n' "$*"; }

# One line on stderr, exit code 2: the command cannot do its work.
die() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 2
}

# The last words of a log that somebody may want to see while it grows, cut to one line.
last_line() { tail -n 1 "$1" 2>/dev/null | tr -d '\r' | cut -c 1-100; }

# step NAME COMMAND...: runs a long command with its output in build/log/NAME.log; says every 20 s how
# far it is, how long it took, and on failure the end of the log. Returns the command's code.
step() {
  local name=$1 log=$log_dir/$1.log begin=$SECONDS code=0
  shift
  mkdir -p "$log_dir"
  say "-- $name ..."
  "$@" >"$log" 2>&1 &
  local child=$!
  while kill -0 "$child" 2>/dev/null; do
    # A finished child is noticed within a second; the wait is interrupted by Ctrl-C.
    for _ in {1..20}; do
      sleep 1
      kill -0 "$child" 2>/dev/null || break 2
    done
    say "   $((SECONDS - begin)) s: $(last_line "$log")"
  done
  wait "$child" || code=$?
  if ((code == 0)); then
    say "-- $name: done in $((SECONDS - begin)) s"
  else
    say "-- $name: FAILED after $((SECONDS - begin)) s, exit code $code; the end of $log:"
    tail -n 40 "$log"
  fi
  return "$code"
}

# configure PRESET: configures build/PRESET.
configure() {
  step "configure-$1" cmake --preset "$1" -S "$root"
}

# build PRESET [TARGET...]: builds the named targets, or all.
build() {
  local preset=$1
  shift
  (cd "$root" && cmake --build --preset "$preset" -j "$jobs" ${1:+--target "$@"})
}
