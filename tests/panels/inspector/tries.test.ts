import { describe, expect, test } from 'vitest'
import { simulate, traceFrame } from '../../../src/physics/index.ts'
import type { Experiment, PolicyStep } from '../../../src/physics/index.ts'
import { textOf } from '../../../src/panels/inspector/said.ts'
import { policyWords } from '../../../src/panels/inspector/stepWords.ts'
import { partName, triesIn, tryWords } from '../../../src/panels/inspector/tries.ts'

const spring: Experiment = {
  scene: 'spring',
  parameters: { position: 1.5 },
  integrator: 'rk4',
  timestep: { kind: 'tolerance', tolerance: 1e-6 },
  frames: { kind: 'steady', fps: 10 },
  duration: 1,
}
const steps = traceFrame(spring, 1)
const tries = triesIn(steps)

test('steps belong to tries, each of a whole and two halves', () => {
  expect(tries.length).toBeGreaterThan(3)
  expect(tries.flatMap((each) => each.steps)).toEqual(steps)
  for (const each of tries.filter(({ steps }) => steps.length === 3))
    expect(each.steps.map((_, i) => partName(each, i))).toEqual([
      'Whole step',
      'First half',
      'Second half',
    ])
})

test('the first try, of the whole frame, is refused with its figures, and the next is shorter', () => {
  const [first, second] = tries
  expect(first!.attempt.accepted).toBe(false)
  expect(second!.steps[0]!.dt).toBeLessThan(first!.steps[0]!.dt)
  const said = tryWords(first!, second, 4).map(textOf).join(' ')
  expect(said).toContain('over 2⁴ − 1 = 15')
  expect(said).toContain('That is too much: all of it is taken back.')
  expect(said).toMatch(/The next is Δt = 0\.0\d+ s long\./)
})

test('what the words say of a difference is the error that the policy went by', () => {
  for (const { attempt, steps } of tries) {
    const [whole, , { to: halves }] = steps as [PolicyStep, PolicyStep, PolicyStep]
    const apart = Math.abs(halves.s - whole.to.s) + Math.abs(halves.v - whole.to.v)
    const ofHalves = whole.dt === whole.asked
    expect(ofHalves ? apart / 15 : (apart * 16) / 15).toBeCloseTo(attempt.error, 12)
  }
})

test('a stop ends the whole, which is kept and agrees with its halves where nothing is off', () => {
  const kick: Experiment = {
    ...spring,
    ...{ scene: 'ramp', frames: { kind: 'steady', fps: 1 } },
    parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
  }
  const [first, second] = triesIn(traceFrame(kick, 1))
  expect(first!.steps.map((_, i) => partName(first!, i))).toEqual([
    ...['Up to the event', 'First half', 'Second half', 'Up to the event, to keep'],
  ])
  expect(first!.steps.map(({ takenBack }) => takenBack)).toEqual([true, true, true, false])
  const said = tryWords(first!, second, 4).map(textOf).join(' ')
  expect(said).toContain('in two halves, at the same, to rounding.')
  expect(said).toContain('So the whole is kept, which ends at the event exactly.')
})

describe('the frame', () => {
  test('says how many were kept and taken back', () => {
    const refused = tries.filter(({ attempt }) => !attempt.accepted).length
    const words = textOf(policyWords(simulate(spring), 1, steps))
    expect(words).toContain('An error of 1\u202fµm is allowed in each second')
    expect(words).toContain(`${tries.length - refused} tries are kept`)
    expect(words).toContain(refused === 1 ? 'one is taken back' : `${refused} are taken back`)
  })

  test('of a policy that does not try has none', () => {
    expect(triesIn(traceFrame({ ...spring, timestep: { kind: 'variable' } }, 1))).toEqual([])
  })
})
