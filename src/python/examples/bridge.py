"""Planks on hinges carry boxes and balls: `bridge` of Box2D-py."""

import tumble

world = tumble.World(gravity=(0, -10))
ground = world.add_body("static", shapes=[tumble.segment((-40, 0), (40, 0))])
planks, before = [], ground
for i in range(30):
    plank = world.add_body(shapes=[tumble.box(1, 0.25)], position=(-14.5 + i, 5), density=20, friction=0.2)
    world.add_joint("revolute", before, plank, anchor=(-15 + i, 5))
    planks.append(plank)
    before = plank
hinge = world.add_joint("revolute", before, ground, anchor=(15, 5))
loads = [world.add_body(shapes=[tumble.box(1, 1)], position=(-8 + 8 * i, 12)) for i in range(2)]
loads += [world.add_body(shapes=[tumble.circle(0.5)], position=(-6 + 6 * i, 10)) for i in range(3)]
world.step(600)
a, b = hinge.anchors
print(f"lowest plank {min(plank.position[1] for plank in planks):.2f} m, hinge open by {abs(a[0] - b[0]):.5f} m")
