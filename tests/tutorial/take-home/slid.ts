import { step } from '../../../src/tutorial/take-home/step3d.ts'
import type { Case3d, Row3d, Triple } from './cases3d.ts'

const vector = ([x, y, z]: Triple) => ({ x, y, z })

/** What the step in three dimensions makes of a case, frame by frame, from the origin on. */
export function slid(one: Omit<Case3d, 'name' | 'rows'>): Row3d[] {
  const body = { position: { x: 0, y: 0, z: 0 }, velocity: vector(one.velocity) }
  const { muStatic, muKinetic } = one
  return one.frames.map((dt) => {
    step(body, dt, vector(one.gravity), vector(one.normal), muStatic, muKinetic)
    const { position, velocity } = body
    return [position.x, position.y, position.z, velocity.x, velocity.y, velocity.z]
  })
}
