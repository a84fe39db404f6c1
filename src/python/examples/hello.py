"""A box falls on the ground: "Hello World" of Box2D's manual, and the first example of pymunk's page."""

import tumble

world = tumble.World(gravity=(0, -10))
world.add_body("static", shapes=[tumble.box(100, 20)], position=(0, -10))
box = world.add_body(shapes=[tumble.box(2, 2)], position=(0, 4), density=1, friction=0.3)
for _ in range(90):
    world.step()
x, y = box.position
print(f"{x:.2f} {y:.2f} {box.angle:.2f}")
