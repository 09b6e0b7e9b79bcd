extends Node2D

var velocity := Vector2.ZERO


## Moves a body that slides on a surface by delta seconds.
func step(
	delta: float, gravity: Vector2, normal: Vector2, mu_static: float, mu_kinetic: float
) -> void:
	# 1. Gravity drives along the surface and presses into it.
	var along := Vector2(normal.y, -normal.x)
	var drive := gravity.dot(along)
	var press := maxf(0.0, -gravity.dot(normal))
	var hold := maxf(mu_static, mu_kinetic) * press
	var speed := velocity.dot(along)
	var moved := 0.0
	var left := delta
	while left > 0.0:
		# 2. At rest, static friction decides: stay, or set off.
		if speed == 0.0 and absf(drive) <= hold:
			break
		# 3. Sliding, friction pulls against the way it slides.
		var slip := signf(speed if speed != 0.0 else drive)
		var a := drive - slip * mu_kinetic * press
		# 4. If it stops within the step, go only to that instant.
		var stops := slip * a < 0.0 and -speed / a <= left
		var t := -speed / a if stops else left
		# 5. Along the parabola: exact while the force is constant.
		moved += (speed + 0.5 * a * t) * t
		speed = 0.0 if stops else speed + a * t
		# 6. Go on with what is left of the step.
		left -= t
	position += along * moved
	velocity = along * speed
