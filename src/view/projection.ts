import type { Parameters, Scene } from '../physics/index.ts'
import type { Point } from '../chart/geometry.ts'

/** How metres become pixels: x to the right, y upwards in metres, downwards in pixels. */
export interface Camera {
  /** Pixels to a metre. */
  readonly scale: number
  /** Where the world's origin lies [px]. */
  readonly x: number
  readonly y: number
}

/** A point of the world that must be seen, and the room around it that must be seen with it [px]. */
export interface Subject extends Point {
  readonly left: number
  readonly right: number
  readonly above: number
  readonly below: number
}

/** The smallest and the largest scale [px/m]. */
const SMALLEST = 1e-12
const LARGEST = 1e12

/** As much of a canvas as what is around the subjects may take: where it is low, words and arrows give way. */
const AROUND = 0.8

/** The largest camera that sees all subjects on a canvas, in its middle. It changes continuously with its subjects. */
export function fit(subjects: readonly Subject[], width: number, height: number): Camera {
  const around = reach(subjects, 0)
  const across = Math.min(1, (AROUND * width) / (around.right - around.left))
  const down = Math.min(1, (AROUND * height) / (around.bottom - around.top))
  // Halving the range of its logarithm: what a subject needs grows with the scale, whatever room is around it.
  let low = Math.log(SMALLEST)
  let high = Math.log(LARGEST)
  for (let i = 0; i < 48; i++) {
    const middle = (low + high) / 2
    const { left, right, top, bottom } = reach(subjects, Math.exp(middle), across, down)
    if (right - left <= width && bottom - top <= height) low = middle
    else high = middle
  }
  const scale = Math.exp(low)
  const { left, right, top, bottom } = reach(subjects, scale, across, down)
  return { scale, x: (width - left - right) / 2, y: (height - top - bottom) / 2 }
}

/**
 * The box around all subjects at a scale, the world's origin in pixel (0, 0).
 *
 * @param across the part of the room beside each that it gets
 * @param down the part of the room above and below
 */
function reach(subjects: readonly Subject[], scale: number, across = 1, down = 1) {
  let left = Infinity
  let right = -Infinity
  let top = Infinity
  let bottom = -Infinity
  for (const subject of subjects) {
    const x = subject.x * scale
    const y = -subject.y * scale
    left = Math.min(left, x - across * subject.left)
    right = Math.max(right, x + across * subject.right)
    top = Math.min(top, y - down * subject.above)
    bottom = Math.max(bottom, y + down * subject.below)
  }
  return { left, right, top, bottom }
}

/** A point of the track on the canvas. */
export interface Spot extends Point {
  /** Unit vector along the track in the direction of growing s. */
  readonly along: Point
  /** Unit vector away from the ground. */
  readonly out: Point
  /** How much a block that stands here is turned, clockwise [rad]. */
  readonly turn: number
  /** How fast the ground falls to the right [rad]: negative where it rises. */
  readonly descent: number
  /** Of the track: positive where it bends upwards [1/px]. */
  readonly curvature: number
}

/** A point of the scene's track in metres, turned to the side that pictures show it from. */
export function worldPoint(scene: Scene, parameters: Parameters, s: number): Point {
  const { x, y } = scene.place(parameters, s)
  return { x: scene.facing * x, y }
}

/** Shows distances along a scene's track on a canvas. */
export class Projection {
  constructor(
    private readonly scene: Scene,
    private readonly parameters: Parameters,
    readonly camera: Camera,
  ) {}

  at(s: number): Spot {
    const { facing } = this.scene
    const { x, y, slope, curvature } = this.scene.place(this.parameters, s)
    const { camera } = this
    const sin = Math.sin(slope)
    const cos = Math.cos(slope)
    return {
      x: camera.x + camera.scale * facing * x,
      y: camera.y - camera.scale * y,
      along: { x: facing * cos, y: sin },
      out: { x: facing * sin, y: -cos },
      turn: facing * slope,
      descent: facing * slope,
      curvature: curvature / camera.scale,
    }
  }
}
