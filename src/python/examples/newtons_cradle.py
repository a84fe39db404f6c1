"""Five balls on rods hand on their momentum: `newtons_cradle` of pymunk."""

import numpy as np

import tumble

world = tumble.World(gravity=(0, -9.8), steps_per_second=240, sleeping=False, joints="direct", impacts="in_order")
frame = world.add_body("static")
balls = []
for i in range(5):
    x, angle = 0.4 * i, -0.6 if i == 0 else 0.0  # the first is lifted
    position = (x + 2 * np.sin(angle), 2 - 2 * np.cos(angle))
    ball = world.add_body(shapes=[tumble.circle(0.2)], position=position, angle=angle, restitution=1, friction=0)
    world.add_joint("revolute", frame, ball, anchor_a=(x, 2), anchor_b=(0, 2), reference_angle=0)
    balls.append(ball)
swing = [0.0] * 5
for _ in range(360):
    world.step()
    swing = [max(swing[i], balls[i].position[0] - 0.4 * i) for i in range(5)]
print("largest deflections to the right:", [round(float(x), 2) for x in swing])
