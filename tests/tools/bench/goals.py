"""The goals of tests/tools/bench/goals.json: what each scene may cost."""
import json
import pathlib

ALL = json.loads(pathlib.Path(__file__).with_name("goals.json").read_text())
SCENES = [scene for scene in ALL if scene.startswith("S")]
FLAT = ("S1", "S2")  # scenes of clears and flat fills
WITHIN = 1.25  # factor of a goal that an emulated board may take


def instructions(board, scene, tier):
    """Returns the instructions that a frame may take at most, or None."""
    of_scene = ALL.get(scene, {})
    goal, factor = of_scene.get(tier, {}).get("m4"), {"m4": 1.0, "m3": ALL["m3"], "m0+": of_scene.get("m0+")}[board]
    if isinstance(factor, dict):
        factor = factor.get(tier)
    return None if goal is None or factor is None else goal * factor * 1e6


def dithering(counts):
    """Returns the instructions that GL_DITHER takes more for each stored fragment, from an entry of golden.json."""
    return (counts["dithered"] - counts["instructions"]) / max(counts["fragments"], 1)


def speed(scene, tier):
    """Returns how many times as fast as llvmpipe the scene must be at least, or None."""
    return ALL.get(scene, {}).get(tier, {}).get("x86")


def peer(scene, tier):
    """Returns the instructions of the best other GL without an FPU, or None if this tier is not compared with it."""
    of_scene = ALL.get(scene, {})
    return of_scene["peer"] * 1e6 if "peer" in of_scene and tier == of_scene.get("peer_tier", "balanced") else None
