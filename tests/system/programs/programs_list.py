"""The programs that tests/system/programs/gallery.py runs: screen savers, and programs of toolkits.

`./dev setup --gallery` installs them.
"""
import pathlib

HACKS = pathlib.Path("/usr/libexec/xscreensaver")
SDL = pathlib.Path("/usr/libexec/installed-tests/SDL2")
# Debian puts some games into a folder beside the other programs.
BINARIES = (pathlib.Path("/usr/games"), pathlib.Path("/usr/bin"))
# The program mapscroller is left out because it fetches maps from the net, and xscreensaver-gl-visual because it only prints.
SAVERS = """antinspect antmaze antspotlight atlantis atunnel beats blinkbox blocktube boing bouncingcow boxed bubble3d cage carousel
    chompytower circuit cityflow companioncube covid19 crackberg crumbler cube21 cubenetic cubestack cubestorm cubetwist cubicgrid
    dangerball deepstars discoball dymaxionmap endgame energystream engine esper etruscanvenus extrusion flipflop flipscreen3d
    fliptext flurry flyingtoasters gears geodesic geodesicgears gflux gibson glblur glcells gleidescope glhanoi glknots glmatrix
    glplanet glschool glslideshow glsnake gltext gravitywell handsy headroom hexstrut hextrail hilbert hydrostat hypertorus
    hypnowheel jigglypuff jigsaw juggler3d kaleidocycle klein lament lavalite lockward maze3d menger mirrorblob moebius moebiusgears
    molecule morph3d nakagin noof peepers photopile pinion pipes polyhedra polytopes projectiveplane providence pulsar quasicrystal
    queens raverhoop razzledazzle romanboy rubik rubikblocks sballs sierpinski3d skytentacles sonar sphereeversion spheremonics
    splitflap splodesic sproingies squirtorus stairs starwars stonerview superquadrics surfaces tangram timetunnel topblock tronbit
    unicrud unknownpleasures vigilance voronoi winduprobot""".split()
SDL_PROGRAMS = """testgl2 testdraw2 testsprite2 testspriteminimal testrendertarget testviewport testscale testgeometry testrendercopyex
    teststreaming testintersections testdrawchessboard testoverlay2 testwm2 testcustomcursor testhittesting testyuv
    testshader""".split()
GLUT_PROGRAMS = ["billard-gl", "openuniverse", "stormbaancoureur", "cultivation"]
# What is known about programs that do not pass, beside what was measured.
KNOWN = {
    "cubicgrid": "its points are 2.5 pixels wide; GL rounds that to the nearest integer, which is 3 here and 2 in Mesa; GL leaves that "
                 "open",
    "klein": "its outlined quads are cut by the view volume; edges that clipping makes are boundary edges and are drawn (GL 1.3, 2.11), "
             "but not by Mesa",
    "molecule": "apitrace asks for GL_MAX_TEXTURE_COORDS when it records glDrawArrays, GL 1.5 has no such state, and the program ends at "
                "that error of the tracer's; by itself it runs",
    "splitflap": "apitrace asks for GL_MAX_TEXTURE_COORDS when it records glInterleavedArrays, GL 1.5 has no such state, and the program "
                 "ends at that error of the tracer's; by itself it runs",
    "winduprobot": "its lines are smooth, and reach behind the eye into fog; without GL_LINE_SMOOTH and GL_FOG the pictures agree "
                   "(smooth lines have a verdict of their own, and behind the eye Mesa takes the fog's distance without its sign)",
    "testcustomcursor": "clears the window, and shows its cursor by X alone",
    "testrendertarget": "needs framebuffer objects, which GL 1.5 does not have, and ends by itself",
}
# The programs of the contact sheet, row by row.
SHEET = """billard-gl stormbaancoureur openuniverse imgui-glfw
           testgl2 atlantis bouncingcow molecule
           gears glknots lament topblock
           dangerball hilbert polyhedra rubik""".split()


class Program:
    """A program, the trace API that sees its calls, and the folder that it starts in."""
    def __init__(self, name, suite, command, api, folder=None):
        self.name, self.suite, self.command, self.api, self.folder = name, suite, command, api, folder


def game(name):
    """Returns the path of a game, whether it is installed or not."""
    return next((folder / name for folder in BINARIES if (folder / name).exists()), BINARIES[0] / name)


def every(imgui):
    """Returns all installed programs. `imgui` is the program that was built with Dear ImGui, or None."""
    found = [Program(n, "xscreensaver", [HACKS / n], "egl") for n in SAVERS]
    found += [Program(n, "SDL2", [SDL / n], "gl", SDL) for n in SDL_PROGRAMS]
    found += [Program(n, "freeglut", [game(n)], "gl") for n in GLUT_PROGRAMS]
    found += [Program("pax-britannica", "GLFW", [game("pax-britannica")], "gl")]
    if imgui is not None:
        found += [Program(f"imgui-{kit}", "Dear ImGui", [imgui, kit], "gl") for kit in ("glfw", "sdl2")]
    return [program for program in found if program.command[0].exists()]
