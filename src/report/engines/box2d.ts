import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { directions, halfBlock, slopeSize } from './engine.ts'
import type { Engine } from './engine.ts'

/** Box2D 2.4 in WebAssembly, in single precision. */
export const box2d: Engine = {
  id: 'box2d-wasm',
  package: 'box2d-wasm',
  setup:
    'metres, single precision, 8 velocity and 3 position iterations, no sleeping; friction is √(μμ) = μ.',
  load: async () => {
    const { default: load } = await import('box2d-wasm')
    // Left to itself it would fetch the file, which Node has a `fetch` for, but not for files.
    const file = createRequire(import.meta.url).resolve('box2d-wasm/dist/umd/Box2D.simd.wasm')
    const b2 = await load({ wasmBinary: readFileSync(file).buffer })
    // A vector is memory of the engine's own that nothing collects: one for each purpose, made once.
    const gravityVector = new b2.b2Vec2(0, 0)
    const velocity = new b2.b2Vec2(0, 0)
    return ({ angle, friction, gravity }) => {
      const { sin, cos } = directions(angle)
      gravityVector.Set(0, -gravity)
      const world = new b2.b2World(gravityVector)
      world.SetAllowSleeping(false)
      const body = (above: number, halfWidth: number, halfHeight: number, dynamic: boolean) => {
        const definition = new b2.b2BodyDef()
        if (dynamic) definition.type = b2.b2_dynamicBody
        definition.position.Set(above * sin, above * cos)
        definition.angle = (-angle * Math.PI) / 180
        definition.fixedRotation = true
        const made = world.CreateBody(definition)
        const shape = new b2.b2PolygonShape()
        shape.SetAsBox(halfWidth, halfHeight)
        const fixture = new b2.b2FixtureDef()
        fixture.shape = shape
        fixture.density = 1 / (4 * halfWidth * halfHeight)
        fixture.friction = friction
        fixture.restitution = 0
        made.CreateFixture(fixture)
        for (const used of [definition, shape, fixture]) b2.destroy(used)
        return made
      }
      const { halfLength, halfThickness } = slopeSize
      body(-halfThickness, halfLength, halfThickness, false)
      const block = body(halfBlock, halfBlock, halfBlock, true)
      return {
        pull: (along, into) => {
          gravityVector.Set(along * cos - into * sin, -along * sin - into * cos)
          world.SetGravity(gravityVector)
        },
        push: (speed) => {
          velocity.Set(speed * cos, -speed * sin)
          block.SetLinearVelocity(velocity)
        },
        step: (dt) => world.Step(dt, 8, 3),
        along: () => block.GetPosition().x * cos - block.GetPosition().y * sin,
        above: () => block.GetPosition().x * sin + block.GetPosition().y * cos,
        speed: () => block.GetLinearVelocity().x * cos - block.GetLinearVelocity().y * sin,
        friction: () => world.GetContactList().GetFriction(),
        free: () => b2.destroy(world),
      }
    }
  },
}
