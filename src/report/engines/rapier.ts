import { directions, halfBlock, slopeSize } from './engine.ts'
import type { Engine } from './engine.ts'

/** Rust in WebAssembly, in single precision. By default the coefficient is the mean of both bodies'. */
export const rapier: Engine = {
  id: 'rapier2d',
  package: '@dimforge/rapier2d-compat',
  setup:
    'metres, single precision, its default 4 solver iterations, no sleeping; friction is the mean of μ and μ.',
  load: async () => {
    const { default: R } = await import('@dimforge/rapier2d-compat')
    await R.init()
    return ({ angle, friction, gravity }) => {
      const { sin, cos } = directions(angle)
      const world = new R.World({ x: 0, y: -gravity })
      const place = (along: number, above: number) =>
        [along * cos + above * sin, -along * sin + above * cos] as const
      const surfaced = (halfWidth: number, halfHeight: number) =>
        R.ColliderDesc.cuboid(halfWidth, halfHeight)
          .setFriction(friction)
          .setFrictionCombineRule(R.CoefficientCombineRule.Average)
          .setRestitution(0)
      const { halfLength, halfThickness } = slopeSize
      const turned = (-angle * Math.PI) / 180
      const ground = world.createRigidBody(
        R.RigidBodyDesc.fixed()
          .setTranslation(...place(0, -halfThickness))
          .setRotation(turned),
      )
      world.createCollider(surfaced(halfLength, halfThickness), ground)
      const block = world.createRigidBody(
        R.RigidBodyDesc.dynamic()
          .setTranslation(...place(0, halfBlock))
          .setRotation(turned)
          .lockRotations()
          .setCanSleep(false),
      )
      world.createCollider(surfaced(halfBlock, halfBlock).setMass(1), block)
      return {
        pull: (along, into) => {
          world.gravity = { x: along * cos - into * sin, y: -along * sin - into * cos }
        },
        push: (speed) => block.setLinvel({ x: speed * cos, y: -speed * sin }, true),
        step: (dt) => {
          world.timestep = dt
          world.step()
        },
        along: () => block.translation().x * cos - block.translation().y * sin,
        above: () => block.translation().x * sin + block.translation().y * cos,
        speed: () => block.linvel().x * cos - block.linvel().y * sin,
        // It does not tell; both bodies' coefficients are μ, and their mean is.
        friction: () => NaN,
        free: () => world.free(),
      }
    }
  },
}
