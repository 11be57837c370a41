"""What each scene may cost: tests/bench/goals.json."""
import json
import pathlib

ALL = json.loads(pathlib.Path(__file__).with_name("goals.json").read_text())
SCENES = [scene for scene in ALL if scene.startswith("S")]
FLAT = ("S1", "S2")  # clears and flat fills
WITHIN = 1.25  # times a goal that an emulated board may take


def instructions(board, scene, tier):
    """Of a frame at most, or None."""
    of_scene = ALL.get(scene, {})
    goal, factor = of_scene.get(tier, {}).get("m4"), {"m4": 1.0, "m3": ALL["m3"], "m0+": of_scene.get("m0+")}[board]
    if isinstance(factor, dict):
        factor = factor.get(tier)
    return None if goal is None or factor is None else goal * factor * 1e6


def dithering(counts):
    """Instructions that GL_DITHER takes more for each stored fragment, of an entry of golden.json"""
    return (counts["dithered"] - counts["instructions"]) / max(counts["fragments"], 1)


def speed(scene, tier):
    """Times as fast as llvmpipe at least, or None."""
    return ALL.get(scene, {}).get(tier, {}).get("x86")


def peer(scene, tier):
    """Instructions of the best other GL without an FPU, or None where it is not held against this tier."""
    of_scene = ALL.get(scene, {})
    return of_scene["peer"] * 1e6 if "peer" in of_scene and tier == of_scene.get("peer_tier", "balanced") else None
