import type { Parameters, Scene } from '../physics/index.ts'
import type { Point } from '../chart/geometry.ts'
import type { Camera } from './camera.ts'

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
