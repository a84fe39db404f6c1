"""A pyramid of boxes comes to rest: `pyramid` of Box2D-py, `box2d_pyramid` of pymunk."""

import tumble

world = tumble.World(gravity=(0, -10))
world.add_body("static", shapes=[tumble.segment((-40, 0), (40, 0))])
for row in range(20):
    for i in range(20 - row):
        world.add_body(shapes=[tumble.box(1, 1)], position=(1.125 * (i - 0.5 * (20 - row)), 0.55 + 1.05 * row), density=5)
while world.time < 20 and any(body.awake for body in world.bodies if body.type == "dynamic"):
    world.step(10)
top = world.positions[:, 1].max()
print(f"{len(world)} bodies sleep after {world.time:.1f} s, the top at {top:.2f} m")
