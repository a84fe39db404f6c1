"""A car with sprung wheels drives over hills: `car` of Box2D-py."""

import tumble

world = tumble.World(gravity=(0, -10))
heights = [0.25, 1, 4, 0, 0, -1, -2, -2, -1.25, 0]
points = [(-20, 0), (20, 0)] + [(20 + 5 * (i + 1), height) for i, height in enumerate(heights * 2)] + [(160, 0)]
world.add_body("static").add_chain(points, two_sided=True, friction=0.6)

hull = [(-1.5, -0.5), (1.5, -0.5), (1.5, 0), (0, 0.9), (-1.15, 0.9), (-1.5, 0.2)]
car = world.add_body(shapes=[tumble.polygon(hull)], position=(0, 1), density=1)
wheels = []
for x, y, torque in ((-1, 0.35, 20), (1, 0.4, 10)):
    wheel = world.add_body(shapes=[tumble.circle(0.4)], position=(x, y), density=1, friction=0.9)
    wheels.append(world.add_joint("wheel", car, wheel, anchor=(x, y), axis=(0, 1), motor=(0, torque), spring=(4, 0.7)))
for _ in range(12 * 60):
    for wheel_joint in wheels:
        wheel_joint.motor_speed = -10  # rad/s, clockwise: to the right
    world.step()
print(f"the car is at {car.position[0]:.1f} m")
