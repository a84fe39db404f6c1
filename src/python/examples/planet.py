"""Boxes orbit a planet by a force of their own in each step: `planet` of pymunk."""

import numpy as np

import tumble

PULL = 100.0  # m^3/s^2
# At the step's end bodies move by the semi-implicit scheme, which keeps the energy of orbits under a force that is
# constant during each step.
world = tumble.World(gravity=(0, 0), steps_per_second=240, sleeping=False, impacts="at_step_end")
world.add_body("static", shapes=[tumble.circle(1)])
boxes = []
for radius in (4.0, 6.0, 8.0):
    speed = np.sqrt(PULL / radius)
    boxes.append(world.add_body(shapes=[tumble.box(0.2, 0.2)], position=(radius, 0), velocity=(0, speed)))
for _ in range(5 * 240):
    for box in boxes:
        position = np.array(box.position)
        distance = np.linalg.norm(position)
        box.apply_force(-PULL * box.mass * position / distance**3)
    world.step()
radii = [float(np.hypot(*box.position)) for box in boxes]
print("radii of the orbits:", [round(radius, 2) for radius in radii])
