#!/usr/bin/env python3
"""Tests `spangle profile` as a user meets it.

usage: command.py SPANGLE
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "boards/tools"), str(ROOT / "tests/support")]
import profile  # noqa: E402
from checks import check, failures  # noqa: E402


def main():
    if len(sys.argv) != 2:
        print(__doc__.strip())
        return 2

    def run(*words):
        return subprocess.run([sys.argv[1], "profile", *words], capture_output=True, text=True)

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        out = folder / "scene.cmake"
        for words, says in ((("--out", str(out)), "takes a scene or --model"), (("S5", "S6", "--out", str(out)), "come after --"),
                            (("S5", "--trace", "x.trace", "--out", str(out)), "takes a scene or --model"), (("--trace", str(folder / "no.trace"), "--out", str(out)), "no trace"), (("S5", "--out", str(folder / "x.txt")), ".cmake"), (("NONE", "--out", str(out)), "no scene"),
                            (("S5", "--size", "0x9", "--out", str(out)), "--size"), (("S5", "--tiers", "quick", "--out", str(out)), "--tiers"),
                            (("S9", "--tiers", "fast", "--max-error", "0", "--size", "80x60", "--out", str(out)), "no tier is within 0 %")):
            done = run(*words)
            check(done.returncode == 2 and says in done.stderr and not out.exists(), f"{words}: {done.returncode} {done.stderr!r}")

        done = run("S5", "--frames", "2", "--size", "160x120", "--out", str(out), "--json")
        check(done.returncode == 0, f"S5: {done.stderr}")
        told = json.loads(done.stdout)
        check(set(told["tiers"]) == {"exact", "balanced", "fast"} and told["tier"] == "exact", f"the most accurate tier, where no error is named: {told['tier']}")
        check({"LISTS", "LIGHTING"} <= set(told["features"]) and "FOG" not in told["features"], f"S5: {told['features']}")
        check(told["limits"]["MODELVIEW_STACK"] == 2 and told["commands"]["glCallList"] == 6, f"S5: {told['limits']}")
        defined = profile.definitions(str(out))
        check("SPANGLE_FEATURE_FOG=0" in defined and "SPANGLE_FEATURE_LISTS=0" not in defined, "profile.py reads it")
        check(f'SPANGLE_FUSED="{out.with_suffix(".inc").resolve()}"' in defined, f"the list of spans lies beside it: {defined}")

        check(told["ranges"]["SURFACE_WIDTH"] == 160 and told["ranges"]["LIST_VERTICES"] > 100 and told["ranges"]["PERSPECTIVE"] == 1, f"S5: {told['ranges']}")
        check("set(SPANGLE_RANGES SURFACE_WIDTH=160 " in out.read_text(), "the ranges stand in the profile")

        check(told["chain"] is False and told["chain_percent"] == 0, f"S5 has loops: {told['chain_percent']} %")
        wires = json.loads(run("HUD", "--tiers", "balanced", "--size", "160x120", "--out", str(out), "--json").stdout)
        chain = sum(key["pixels"] for key in wires["keys"] if not key["fused"]) / sum(key["pixels"] for key in wires["keys"])
        check(wires["chain"] is True and chain > 0 and abs(chain - wires["chain_percent"] / 100) < 1e-6, f"HUD: {wires['chain_percent']} %")
        # Without the sources there is no firmware: the program says so in one sentence, and writes no page.
        page = folder / "page.html"
        bare = subprocess.run([sys.argv[1], "profile", "S5", "--tiers", "balanced", "--size", "80x60", "--out", str(out), "--report", str(page)],
                              capture_output=True, text=True, env=os.environ | {"SPANGLE_SOURCES": str(folder)})
        check(bare.returncode == 1 and "SPANGLE_SOURCES" in bare.stderr and not page.exists(), f"--report without sources: {bare.returncode} {bare.stderr!r}")

        cheap = json.loads(run("S5", "--max-error", "50", "--size", "160x120", "--out", str(out), "--json").stdout)
        check(cheap["tier"] == "fast" and cheap["limits"]["TIER_SET"] == "fast", "the cheapest tier within the bound")
        run("S7", "--no-clipping", "--tiers", "fast", "--size", "160x120", "--out", str(out))
        check("set(SPANGLE_CLIPPING 0)\nset(SPANGLE_PERSPECTIVE 0)\n" in out.read_text(), "sprites need neither clipping nor perspective")
        text = run("S5", "--tiers", "balanced", "--size", "160x120", "--out", str(out)).stdout
        check("in the tier balanced" in text and "glCallList" in text and "state key" in text, f"the report: {text}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
