import Matter from 'matter-js'
import { directions, halfBlock, slopeSize } from './engine.ts'
import type { Engine } from './engine.ts'

const { Bodies, Body, Composite, Engine } = Matter

/** Matter counts in pixels and milliseconds; its default gravity is 1000 px/s², so this is its natural scale. */
const PIXELS = 100
/** Body.setVelocity takes pixels for each of these [s]. */
const BASE = 1 / 60

/** The y axis points down. Friction is the smaller of both bodies', but not Coulomb's: see `setup`. */
export const matter: Engine = {
  id: 'matter-js',
  package: 'matter-js',
  setup:
    '100 px to the metre, no air friction, no sleeping; at less than 60 fps its steps are longer than the 16.667 ms that it recommends. Its friction is a loss of speed for each solver iteration, whatever the normal force: a coefficient of μ is not Coulomb’s μ.',
  load: () =>
    Promise.resolve(({ angle, friction, gravity }) => {
      const { sin, cos } = directions(angle)
      // It would say for each process that a step is longer than recommended: `setup` says it once.
      Object.assign(Matter.Common, { logLevel: 0 })
      const engine = Engine.create({ enableSleeping: false })
      const surface = { friction, frictionAir: 0, restitution: 0 }
      const { halfLength, halfThickness } = slopeSize
      const place = (along: number, above: number) =>
        [PIXELS * (along * cos + above * sin), PIXELS * (along * sin - above * cos)] as const
      const ground = Bodies.rectangle(
        ...place(0, -halfThickness),
        PIXELS * 2 * halfLength,
        PIXELS * 2 * halfThickness,
        { ...surface, isStatic: true, angle: (angle * Math.PI) / 180 },
      )
      const size = PIXELS * 2 * halfBlock
      const block = Bodies.rectangle(...place(0, halfBlock), size, size, {
        ...surface,
        angle: (angle * Math.PI) / 180,
        inertia: Infinity,
      })
      Body.setMass(block, 1)
      Body.setInertia(block, Infinity)
      Composite.add(engine.world, [ground, block])
      // Gravity in px/ms².
      engine.gravity.scale = PIXELS * 1e-6
      const pull = (along: number, into: number) => {
        engine.gravity.x = along * cos - into * sin
        engine.gravity.y = along * sin + into * cos
      }
      pull(gravity * sin, gravity * cos)
      return {
        pull,
        push: (speed) =>
          Body.setVelocity(block, {
            x: PIXELS * BASE * speed * cos,
            y: PIXELS * BASE * speed * sin,
          }),
        step: (dt) => void Engine.update(engine, 1000 * dt),
        along: () => (block.position.x * cos + block.position.y * sin) / PIXELS,
        above: () => (block.position.x * sin - block.position.y * cos) / PIXELS,
        speed: () => {
          const { x, y } = Body.getVelocity(block)
          return (x * cos + y * sin) / PIXELS / BASE
        },
        friction: () => engine.pairs.list[0]?.friction ?? NaN,
        free: () => Engine.clear(engine),
      }
    }),
}
