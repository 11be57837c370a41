#!/usr/bin/env python3
"""Tests that `spangle profile` records traces, and programs that were linked by others.

usage: profile_test.py PAIR SPANGLE
"""
import json
import pathlib
import sys

from harness import HERE, check, failures, folder, need, run, spangle_environment, xvfb

sys.path.insert(0, str(HERE.parents[2] / "boards/tools"))
import profile  # noqa: E402

PAIR, SPANGLE = pathlib.Path(sys.argv[1]), sys.argv[2]


def recorded(name, place, environment, *words):
    """Returns the report of one profile, whose settings builds can read."""
    out = place / f"{name}.cmake"
    ended = run([SPANGLE, "profile", "--tiers", "balanced", "--json", "--out", out, *words], environment, 120)
    check(ended.status == 0 and out.exists(), f"{name}: ended with {ended.status}: {ended.words[-1000:]}")
    if ended.status != 0 or not out.exists():
        return None
    profile.definitions(str(out))
    return json.loads(ended.words[ended.words.index("{"):])


def traces(place, environment):
    light = recorded("light", place, environment, "--trace", HERE / "traces/redbook_light.trace")
    if light is not None:
        check("LIGHTING" in light["features"] and "FOG" not in light["features"], f"light: {light['features']}")
        check(light["limits"]["COLOR_FORMATS"] == "rgb565" and light["limits"]["DEPTH_FORMATS"] == "z16", f"light is for a board: {light['limits']}")
        check(light["commands"]["glVertex"] == 2528 and "glReadPixels" not in light["commands"], f"light: {light['commands']}")
        check(light["tiers"]["balanced"]["different_percent"] < 1, f"light: {light['tiers']}")
        check(sum(key["pixels"] for key in light["keys"]) > 100000, f"light: {light['keys']}")
    own = recorded("own", place, environment, "--trace", HERE / "traces/redbook_light.trace", "--format", "program")
    if own is not None:
        check(own["limits"]["COLOR_FORMATS"] == "rgba8888", f"a retracer's own surfaces have eight bits a component: {own['limits']}")
    gears = recorded("gears", place, environment, "--trace", HERE / "traces/demos_gears.trace", "--frames", "2")
    if gears is not None:
        check(gears["frames"] == 2 and "LISTS" in gears["features"], f"gears: {gears['frames']} {gears['features']}")


def programs(place, environment):
    gears = recorded("glxgears", place, environment, "--frames", "5", "--", "glxgears")
    if gears is not None:
        check(gears["frames"] >= 5 and gears["chain"] is False, f"glxgears: {gears['frames']} frames, chain {gears['chain']}")
    out = place / "none.cmake"
    ended = run([SPANGLE, "profile", "--out", out, "--", "/no/such/program"], environment)
    check(ended.status == 2 and "recorded nothing" in ended.words and not out.exists(), f"no program: {ended.status}: {ended.words}")


need("apitrace", "eglretrace", "glxgears")
with folder("profile") as place:
    traces(place, spangle_environment(PAIR))
    with xvfb() as display:
        programs(place, spangle_environment(PAIR, DISPLAY=display))
sys.exit(1 if failures else 0)
