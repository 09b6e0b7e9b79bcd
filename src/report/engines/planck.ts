import { directions, halfBlock, slopeSize } from './engine.ts'
import type { Engine } from './engine.ts'

/** Box2D in JavaScript. It multiplies the coefficients of both bodies and takes the root. */
export const planck: Engine = {
  id: 'planck',
  package: 'planck',
  setup: 'metres, 8 velocity and 3 position iterations, no sleeping; friction is √(μμ) = μ.',
  load: async () => {
    const { Box, Vec2, World } = await import('planck')
    return ({ angle, friction, gravity }) => {
      const { sin, cos } = directions(angle)
      const world = new World({ gravity: Vec2(0, -gravity), allowSleep: false })
      const place = (along: number, above: number) =>
        Vec2(along * cos + above * sin, -along * sin + above * cos)
      const surface = { friction, restitution: 0 }
      const { halfLength, halfThickness } = slopeSize
      const turned = (-angle * Math.PI) / 180
      world
        .createBody({ position: place(0, -halfThickness), angle: turned })
        .createFixture({ shape: new Box(halfLength, halfThickness), ...surface })
      const block = world.createBody({
        type: 'dynamic',
        position: place(0, halfBlock),
        angle: turned,
        fixedRotation: true,
      })
      block.createFixture({
        shape: new Box(halfBlock, halfBlock),
        density: 1 / (4 * halfBlock * halfBlock),
        ...surface,
      })
      return {
        pull: (along, into) =>
          world.setGravity(Vec2(along * cos - into * sin, -along * sin - into * cos)),
        push: (speed) => block.setLinearVelocity(Vec2(speed * cos, -speed * sin)),
        step: (dt) => world.step(dt, 8, 3),
        along: () => block.getPosition().x * cos - block.getPosition().y * sin,
        above: () => block.getPosition().x * sin + block.getPosition().y * cos,
        speed: () => block.getLinearVelocity().x * cos - block.getLinearVelocity().y * sin,
        friction: () => world.getContactList()?.getFriction() ?? NaN,
        free: () => {},
      }
    }
  },
}
