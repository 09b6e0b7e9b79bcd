import { beforeAll, describe, expect, it } from 'vitest'
import { engines } from '../../src/report/engines/index.ts'
import type { EngineBlock, EngineSlope } from '../../src/report/engines/index.ts'
import { frictionOf } from '../../src/report/engines/measure.ts'
import { runOurs, runEngine } from '../../src/report/engines/run.ts'
import { engineClocks, engineScenes } from '../../src/report/engines/scenes.ts'
import { settled } from '../../src/report/engines/engine.ts'

const gravity = 9.81

/** Rounding of a distance of some metres, once a step for a thousand steps, in single precision [m]. */
const SINGLE = 1000 * 10 * 2 ** -24

describe.each(engines)('$id is set up as it says', (engine) => {
  let make: (slope: EngineSlope) => EngineBlock
  beforeAll(async () => {
    make = await engine.load()
  })

  it.each([0, 15, 30, 60])('a block slides down %d° without friction with g sin α', (angle) => {
    const dt = 1e-3
    const steps = 1000
    const a = gravity * Math.sin((angle * Math.PI) / 180)
    const block = settled(make, { angle, friction: 0, gravity })
    const start = block.along()
    const gap = block.above()
    for (let i = 0; i < steps; i++) block.step(dt)
    const time = steps * dt
    // A method of first order is off by at most ½ a T dt; the contact lets go of a little more.
    const tolerance = 0.55 * a * time * dt + SINGLE
    expect(Math.abs(block.along() - start - 0.5 * a * time * time)).toBeLessThan(tolerance)
    expect(Math.abs(block.speed() - a * time)).toBeLessThan(0.001 * a + SINGLE)
    expect(Math.abs(block.above() - gap)).toBeLessThan(0.01)
    block.free()
  })

  it('no friction at all brakes nothing, and a push is as fast as it says', () => {
    const block = settled(make, { angle: 0, friction: 0, gravity })
    const start = block.along()
    block.push(-3)
    expect(block.speed()).toBeCloseTo(-3, 5)
    for (let i = 0; i < 60; i++) block.step(1 / 60)
    expect(block.along() - start).toBeCloseTo(-3, 4)
    block.free()
  })

  it.each([0.2, 0.5, 0.9])('both coefficients of %d combine to just that', (friction) => {
    const block = settled(make, { angle: 0, friction, gravity })
    const combined = block.friction()
    // Single precision has seven digits; rapier doesn't tell.
    if (engine.id === 'rapier2d') expect(combined).toBeNaN()
    else expect(Math.abs(combined - friction)).toBeLessThan(1e-7)
    block.free()
  })

  it('a block at rest on the flat stays', () => {
    const block = settled(make, { angle: 0, friction: 0.5, gravity })
    const start = block.along()
    for (let i = 0; i < 300; i++) block.step(1 / 60)
    expect(Math.abs(block.along() - start)).toBeLessThan(1e-5)
    block.free()
  })

  it.runIf(engine.id !== 'matter-js').each([0.2, 0.5, 0.9])(
    'a block brakes on the flat with the coefficient of %d that was asked for',
    (friction) => {
      const block = settled(make, { angle: 0, friction, gravity })
      // Impulses of the contact are solved to about a thousandth.
      expect(Math.abs(frictionOf(block, gravity) / friction - 1)).toBeLessThan(2e-3)
      block.free()
    },
  )

  it.runIf(engine.id === 'matter-js')(
    'its friction is not Coulomb’s: half the weight brakes alike',
    () => {
      const brakes = [gravity, gravity / 2].map((weight) => {
        const block = settled(make, { angle: 0, friction: 0.05, gravity: weight })
        block.push(6)
        for (let i = 0; i < 3; i++) block.step(1 / 60)
        const lost = 6 - block.speed()
        block.free()
        return lost
      })
      expect(brakes[0]).toBeGreaterThan(0)
      expect(brakes[1]! / brakes[0]!).toBeCloseTo(1, 1)
    },
  )

  it('two runs are the same', () => {
    const [scene, { frames }] = [engineScenes[3]!, engineClocks[4]!]
    expect(runEngine(make, scene, frames)).toEqual(runEngine(make, scene, frames))
  })
})

describe('ours', () => {
  it.each(engineScenes)('$label: two runs are the same, and right to rounding', (scene) => {
    for (const { frames } of engineClocks) {
      const run = runOurs({}, scene, frames)
      expect(run).toEqual(runOurs({}, scene, frames))
      // The bound that the ramp is held to in tests/physics/truth.test.ts, for the distance of 34 m in 60 s.
      expect(run.error).toBeLessThan(1e-11)
      expect(run.note).toBeNull()
    }
  })

  it('the paper’s step trembles where it should rest, and its row says so', () => {
    const stays = engineScenes.find(({ id }) => id === 'uphill-stays')!
    const paper = { integrator: 'semi-implicit-euler', stopping: 'naive' } as const
    expect(runOurs(paper, stays, { kind: 'steady', fps: 10 }).note).toMatch(/still moves/)
  })
})
