extends SceneTree


func _init() -> void:
	for numbers in CASES:
		var body = load("res://step.gd").new()
		body.position = Vector2.ZERO
		body.velocity = Vector2(numbers[0], numbers[1])
		var gravity = Vector2(numbers[2], numbers[3])
		var normal = Vector2(numbers[4], numbers[5])
		for i in range(8, numbers.size()):
			body.step(numbers[i], gravity, normal, numbers[6], numbers[7])
			print(
				(
					"row %.9f %.9f %.9f %.9f"
					% [body.position.x, body.position.y, body.velocity.x, body.velocity.y]
				)
			)
		body.free()
	quit()
