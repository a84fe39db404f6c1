"""tumble: a headless, deterministic 2D physics engine.

>>> import tumble
>>> world = tumble.World()
>>> floor = world.add_body("static", shapes=[tumble.box(20, 1)], position=(0, -0.5))
>>> ball = world.add_body(shapes=[tumble.circle(0.5)], position=(0, 4), restitution=0.8)
>>> world.step(60)
>>> tumble.write_png(world.render(), "ball.png")

Units are m, kg, s and rad; y is up and counter-clockwise is positive.
"""

from tumble.bodies import Body, Locks
from tumble.body_shapes import BodyShape, Filter
from tumble.distances import STATUS, Certificate, Distance, Trace, distance, distances, trace_distance
from tumble.errors import Diagnostic, FileError, InUseError, RenderError, SceneError, SimulationDiverged, SnapshotError
from tumble.joints import Joint
from tumble.queries import BodyDistance, Closest, Hit
from tumble.rendering import fitted_camera, png_bytes, render, write_png
from tumble.scene import Claim, Run, Scene
from tumble.shapes import Shape, box, capsule, circle, polygon, segment
from tumble.stepping import step_all
from tumble.vectors import Vec2
from tumble.video import Video
from tumble.world import World

__version__ = "0.2.0"

__all__ = [
    "STATUS", "Body", "BodyDistance", "BodyShape", "Certificate", "Claim", "Closest", "Diagnostic", "Distance",
    "FileError", "Filter", "Hit", "InUseError", "Joint", "Locks", "RenderError", "Run", "Scene", "SceneError",
    "Shape", "SimulationDiverged", "SnapshotError", "Trace", "Vec2", "Video", "World", "box", "capsule", "circle", "distance",
    "distances", "fitted_camera", "png_bytes", "polygon", "render", "segment", "step_all", "trace_distance",
    "write_png",
]  # fmt: skip
