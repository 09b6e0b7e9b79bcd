import Matter from 'matter-js'
import { describe, expect, it } from 'vitest'
import { frameRateSpread } from '../../src/measure/gameSpread.ts'
import { exact } from '../../src/physics/index.ts'
import { step } from '../../src/tutorial/take-home/step.ts'

/* A game of one's own under the clocks of the spread table. */

const gravity = 9.81

/** A stone that falls from rest, by semi-implicit Euler. */
const stone = {
  start: () => ({ x: 0, v: 0 }),
  frame(it: { x: number; v: number }, dt: number) {
    it.v += gravity * dt
    it.x += it.v * dt
  },
  read: ({ x }: { x: number }) => x,
  duration: 2,
}

const steady = (fps: number) => ({ kind: 'steady', fps }) as const

/**
 * Half the sum of all squared frame lengths [s²], in two seconds of hitches at 60 fps less the same at 240 fps: semi-implicit
 * Euler ends ½ a Σ Δt² too far. The hitches are two of 0.5 s among 60 frames.
 */
const halfSquares = 0.5 * (2 * 0.5 ** 2 + 60 / 60 ** 2 - 480 / 240 ** 2)

describe('the frame-rate spread of a game', () => {
  it('of the step to take home is rounding, and all runs end where the exact motion does', () => {
    const angle = Math.PI / 12
    const normal = { x: Math.sin(angle), y: Math.cos(angle) }
    const along = { x: normal.y, y: -normal.x }
    const { ends, spread } = frameRateSpread({
      start: () => ({
        position: { x: 0, y: 0 },
        velocity: { x: -5 * along.x, y: -5 * along.y },
      }),
      frame: (body, dt) => step(body, dt, { x: 0, y: -gravity }, normal, 0.5, 0.5),
      read: ({ position }) => position,
      duration: 1,
    })
    expect(ends).toHaveLength(11)
    expect(spread).toBeLessThan(1e-12)
    const parameters = { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 }
    const { s } = exact({ scene: 'ramp', parameters }, 1)
    for (const { end } of ends) expect(end.x).toBeCloseTo(s * along.x, 11)
  })

  it('of semi-implicit Euler is ½ a T times the difference of the frames', () => {
    const { spread, sentence, ends } = frameRateSpread({
      ...stone,
      clocks: [steady(10), steady(30), steady(120)],
    })
    expect(spread).toBeCloseTo(0.5 * gravity * 2 * (1 / 10 - 1 / 120), 12)
    expect(sentence).toBe('The game ends 0.899 apart: 19.702 (120 fps) and 20.601 (10 fps).')
    expect(ends.map(({ name, end }) => [name, end])).toEqual([
      ['10 fps', expect.closeTo(20.601, 12)],
      ['30 fps', expect.closeTo(19.947, 12)],
      ['120 fps', expect.closeTo(19.70175, 12)],
    ])
  })

  it('is the worst under hitches, which are among the clocks that nobody has to name', () => {
    const { spread, sentence } = frameRateSpread(stone)
    expect(spread).toBeCloseTo(gravity * halfSquares, 9)
    expect(sentence).toMatch(
      /^The game ends 2\.49 apart: .* \(240 fps\) and .* \(60 fps, hitches\)\.$/,
    )
  })

  const world = {
    start() {
      const engine = Matter.Engine.create()
      const ball = Matter.Bodies.circle(0, 0, 10, { frictionAir: 0 })
      Matter.Composite.add(engine.world, ball)
      return { engine, ball, waiting: 0 }
    },
    read: ({ ball }: { ball: Matter.Body }) => ball.position,
    duration: 2,
  }

  it('of a world of matter-js that takes frames as they come is that of semi-implicit Euler', () => {
    // It would say that these steps are longer than it recommends.
    Object.assign(Matter.Common, { logLevel: 0 })
    const { spread, sentence } = frameRateSpread({
      ...world,
      frame: ({ engine }, dt) => void Matter.Engine.update(engine, 1000 * dt),
    })
    // Its gravity is 0.001 px/ms².
    expect(spread).toBeCloseTo(1000 * halfSquares, 6)
    expect(sentence).toMatch(/^y ends 254 apart: /)
  })

  it('of the same world in fixed steps is a step at the most', () => {
    const { spread } = frameRateSpread({
      ...world,
      frame(it, dt) {
        // 2⁻⁶ s: no sum of whole steps is rounded.
        for (it.waiting += dt; it.waiting >= 1 / 64; it.waiting -= 1 / 64)
          Matter.Engine.update(it.engine, 1000 / 64)
      },
    })
    // It falls at 2000 px/s at the end.
    expect(spread).toBeLessThan(2000 / 64 + 1)
  })

  it('is of the number that differs most', () => {
    const { spread, sentence } = frameRateSpread({
      ...stone,
      read: ({ x, v }) => ({ v, x }),
      clocks: [steady(10), steady(20)],
    })
    expect(spread).toBeCloseTo(0.4905, 12)
    expect(sentence).toMatch(/^x ends 0\.49\d apart/)
  })

  it('of one that ends alike is 0, and says so', () => {
    const { spread, sentence } = frameRateSpread({ ...stone, read: () => 7 })
    expect(spread).toBe(0)
    expect(sentence).toBe('All 11 runs end alike.')
  })

  it('of one that blows up passes no limit', () => {
    const { spread, sentence } = frameRateSpread({
      ...stone,
      frame: (it, dt) => void (it.x = dt > 0.1 ? NaN : 1),
    })
    expect(spread).toBeNaN()
    expect(() => expect(spread).toBeLessThan(0.001)).toThrow()
    expect(sentence).toBe('The game ends at NaN (5 fps).')
  })

  it('keeps the ends of a game that goes on writing to what it gave', () => {
    const shared = { x: 0 }
    const { ends } = frameRateSpread({
      ...stone,
      start: () => shared,
      frame: (it, dt) => void (it.x += dt),
      read: (it) => it,
      clocks: [steady(10), steady(20)],
    })
    expect(ends.map(({ end }) => Math.round(end.x))).toEqual([2, 4])
  })
})

describe('what can’t be measured', () => {
  it.each([
    ['clocks[1].fps', { clocks: [steady(10), steady(0)] }],
    ['duration', { duration: -1 }],
    ['it takes two', { clocks: [steady(10)] }],
    ['read gives undefined; it must give a number', { read: () => undefined as never }],
    ['read gives far for x', { read: () => ({ x: 'far' }) as never }],
    ['read gives an empty object', { read: () => ({}) as never }],
  ])('is refused with the reason: %s', (reason, wrong) => {
    expect(() => frameRateSpread({ ...stone, ...wrong })).toThrow(reason)
  })
})

it('its frames fill the duration, and the last is cut', () => {
  for (const [fps, duration] of [
    [7, 1],
    [10, 0.25],
    [144, 2],
  ] as const) {
    const { ends } = frameRateSpread({
      start: () => ({ time: 0, frames: 0 }),
      frame: (it, dt) => void ((it.time += dt), it.frames++),
      read: (it) => it,
      duration,
      clocks: [steady(fps), steady(60)],
    })
    expect(ends[0]!.end.time).toBeCloseTo(duration, 12)
    expect(ends[0]!.end.frames).toBe(Math.ceil(fps * duration))
  }
})
