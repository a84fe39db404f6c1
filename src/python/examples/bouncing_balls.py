"""Balls rain on two static lines: `bouncing_balls` of pymunk, with the same layout in m in place of pixels."""

import numpy as np

import tumble

world = tumble.World(gravity=(0, -9))
lines = world.add_body("static")
for start, end in (((-1.5, 0.5), (1.0, 0.0)), ((1.0, 0.0), (1.0, 1.0))):
    lines.add_shape(tumble.segment(start, end), restitution=0.95, friction=0.9)

random = np.random.default_rng(1)
balls = []
for step in range(600):
    if step % 60 == 0:
        ball = world.add_body(shapes=[tumble.circle(0.25)], position=(random.uniform(-0.4, 0.4), 3),
                              restitution=0.95, friction=0.9)  # fmt: skip
        balls.append(ball)
    world.step()
    for ball in [ball for ball in balls if ball.position[1] < -5]:  # below the picture
        ball.destroy()
        balls.remove(ball)
print(len(balls), "balls in the picture")
