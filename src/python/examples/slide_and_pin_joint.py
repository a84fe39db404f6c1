"""An L turns on a pin, held by a rope: `slide_and_pinjoint`, the tutorial of pymunk."""

import tumble

world = tumble.World(gravity=(0, -9))
ground = world.add_body("static")
ell = world.add_body(position=(0, 0))
ell.add_shape(tumble.segment((-1.5, 0), (2.55, 0)))
ell.add_shape(tumble.segment((-1.5, 0), (-1.5, 0.5)))
ell.set_mass(10, inertia=10)
pin = world.add_joint("revolute", ground, ell, anchor=(0, 0))  # PivotJoint
# SlideJoint: the distance of two points stays between limits.
rope = world.add_joint("distance", ground, ell, anchor_a=(-1, 0), anchor_b=(-1.5, 0), limits=(0, 0.75))

balls = []
for step in range(300):
    if step % 60 == 0:
        balls.append(world.add_body(shapes=[tumble.circle(0.14)], position=(1.2, 2.5), density=16))
    world.step()
print(f"the L has turned by {ell.angle:.2f} rad, its rope is {rope.position:.2f} m long")
