extends Node3D

var velocity := Vector3.ZERO


## Moves a body that slides on a surface by delta seconds.
func step(
	delta: float, gravity: Vector3, normal: Vector3, mu_static: float, mu_kinetic: float
) -> void:
	# 1. Gravity drives along the surface and presses into it.
	var drive := gravity - normal * gravity.dot(normal)
	var press := maxf(0.0, -gravity.dot(normal))
	var hold := maxf(mu_static, mu_kinetic) * press
	velocity -= normal * velocity.dot(normal)
	var left := delta
	while left > 0.0:
		# 2. At rest, static friction decides: stay, or set off.
		var speed := velocity.length()
		if speed == 0.0 and drive.length() <= hold:
			break
		# 3. Sliding, friction pulls against the way it slides.
		var way := velocity if speed > 0.0 else drive
		var a := drive - way * (mu_kinetic * press / way.length())
		# 4. If it stops within this part of the step, go only to that instant.
		var t := minf(left, maxf(delta / 1000.0, 0.02 * speed / a.length()))
		var brake := -a.dot(way) / way.length()
		var stops := brake > 0.0 and speed / brake <= t
		if stops:
			t = speed / brake
		# 5. The way turns: what it is halfway is right for the whole part.
		var halfway := way if stops else way + a * (t / 2.0)
		a = drive - halfway * (mu_kinetic * press / halfway.length())
		position += velocity * t + a * (t * t / 2.0)
		velocity = Vector3.ZERO if stops else velocity + a * t
		# 6. Go on with what is left of the step.
		left -= t
