# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the tests of examples/scale_out: a collection, and what must be true of its results. Sets `work`, removed at the end.
work=$(mktemp -d "${TMPDIR:-/tmp}/reebquad-scale-XXXXXX")
results=$work/out
number=8

skip() {
  echo "SKIPPED: $1"
  exit 77
}
fail() {
  echo "FAILED: $1"
  exit 1
}

# Meshes that take a part of a second each.
make_meshes() {
  mkdir -p "$work/in"
  for i in $(seq 1 "$number"); do
    "$REEBQUAD" shape genus-2 --triangles $((3000 + 100 * i)) -o "$work/in/$i.off" || fail "no mesh"
  done
}

records() {
  find "$results" -name record.json -printf '%p %T@\n' 2>/dev/null | sort
}

# Waits until a mesh is done; its record and time are kept.
wait_for_a_record() {
  for _ in $(seq 1 600); do
    records >"$work/early"
    [ -s "$work/early" ] && return 0
    sleep 0.05
  done
  fail "no mesh was done in 30 s"
}

# Every mesh is certified, and what was done when the worker was killed was not done again.
check_results() {
  [ "$(records | wc -l)" -eq "$number" ] || fail "$(records | wc -l) of $number meshes are done"
  [ "$(grep -c '"outcome":"certified"' "$results/batch.jsonl")" -eq "$number" ] || fail "not all are certified"
  records | grep -cFf "$work/early" | grep -qx "$(wc -l <"$work/early")" || fail "a mesh was done twice"
  [ "$("$REEBQUAD" batch "$work/in" -o "$results" --pending -- "${options[@]}")" = "" ] || fail "meshes are pending"
  echo "$number meshes, each done once; $(wc -l <"$work/early") were done before a worker was killed"
}

options=(--quads 200 --effort fast)
