"""A fan of rays sees what is nearest: `raycast` of Box2D-py, `segment_query_first` of pymunk."""

import numpy as np

import tumble

world = tumble.World(gravity=(0, 0))
world.add_body("static", shapes=[tumble.box(2, 2)], position=(5, 0))
world.add_body("static", shapes=[tumble.circle(1)], position=(0, 5))

hit = world.cast_ray((0, 0), (10, 0))  # segment_query_first((0, 0), (10, 0), ...)
print(f"to the right: {hit.point} of {hit.body!r}, normal {hit.normal}")

angles = np.linspace(0, np.pi / 2, 91)
hits = world.cast_rays([(0, 0)], 10 * np.stack([np.cos(angles), np.sin(angles)], axis=1))  # all at once
print(int(hits["hit"].sum()), "of", len(hits), "rays hit, at", 10 * hits["fraction"][0], "m and more")
inside = world.overlap(tumble.circle(0.1), (5, 0))  # point_query
