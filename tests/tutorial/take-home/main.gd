extends SceneTree


func _init() -> void:
	for numbers in CASES:
		if numbers[0] == 2.0:
			in_the_plane(numbers)
		else:
			in_space(numbers)
	quit()


func in_the_plane(numbers) -> void:
	var body = load("res://step.gd").new()
	body.position = Vector2.ZERO
	body.velocity = Vector2(numbers[1], numbers[2])
	var gravity = Vector2(numbers[3], numbers[4])
	var normal = Vector2(numbers[5], numbers[6])
	for i in range(9, numbers.size()):
		body.step(numbers[i], gravity, normal, numbers[7], numbers[8])
		var r = body.position
		var v = body.velocity
		print("row %.9f %.9f %.9f %.9f" % [r.x, r.y, v.x, v.y])
	body.free()


func in_space(numbers) -> void:
	var body = load("res://step3d.gd").new()
	body.position = Vector3.ZERO
	body.velocity = Vector3(numbers[1], numbers[2], numbers[3])
	var gravity = Vector3(numbers[4], numbers[5], numbers[6])
	var normal = Vector3(numbers[7], numbers[8], numbers[9])
	for i in range(12, numbers.size()):
		body.step(numbers[i], gravity, normal, numbers[10], numbers[11])
		var r = body.position
		var v = body.velocity
		print("row %.9f %.9f %.9f %.9f %.9f %.9f" % [r.x, r.y, r.z, v.x, v.y, v.z])
	body.free()
