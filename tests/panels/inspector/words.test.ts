import { describe, expect, test } from 'vitest'
import { simulate, traceFrame } from '../../../src/physics/index.ts'
import type { Experiment } from '../../../src/physics/index.ts'
import {
  frameLength,
  policyWords,
  wordsAfter,
  wordsBefore,
} from '../../../src/panels/inspector/stepWords.ts'
import { numeral } from '../../../src/chart/magnitudes.ts'
import { say, textOf } from '../../../src/panels/inspector/said.ts'

const kicked: Experiment = {
  scene: 'ramp',
  parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
  frames: { kind: 'steady', fps: 10 },
  integrator: 'velocity-verlet',
  duration: 1,
}

test.each([
  [0, '0'],
  [-5, '−5'],
  [0.1, '0.1'],
  [1 / 60, '0.016667'],
  [-1.72061234, '−1.7206'],
  [0.1 + 0.2, '0.30000'],
  [1.1102e-16, '1.1102×10⁻¹⁶'],
  [-1234567, '−1.2346×10⁶'],
  [123456.7, '123457'],
  [NaN, 'no number'],
])('%d is written %s', (value, text) => {
  expect(numeral(value)).toBe(text)
})

test('what was said can be said again, its numbers still numbers', () => {
  const inner = say`half of ${1}`
  expect(say`It is ${inner}, ${'not'} ${2}.`.filter((each) => typeof each === 'number')).toEqual([
    1, 2,
  ])
  expect(textOf(say`It is ${inner}, ${'not'} ${2}.`)).toBe('It is half of 1, not 2.')
})

describe('how a frame becomes steps', () => {
  const words = (
    timestep: Experiment['timestep'],
    row: number,
    others: Partial<Experiment> = {},
  ) => {
    const experiment = { ...kicked, timestep: timestep!, ...others }
    return textOf(policyWords(simulate(experiment), row, traceFrame(experiment, row)))
  }

  test.each([
    [{ kind: 'variable' }, 3, 'One step, as long as the frame: 0.1 s.'],
    [{ kind: 'per-frame', step: 0.02 }, 3, 'One step of 0.02 s, however long the frame was.'],
    [
      { kind: 'capped', cap: 0.04 },
      3,
      'One step of 0.04 s, the cap: the other 0.06 s of the frame is lost.',
    ],
    [
      { kind: 'capped', cap: 0.1 },
      3,
      'One step, as long as the frame: 0.1 s is within the cap of 0.1 s.',
    ],
    [
      { kind: 'substeps', step: 0.03 },
      3,
      '0.1 s → 4 equal parts of 0.025 s, none longer than 0.03 s.',
    ],
    [
      { kind: 'substeps', step: 0.03, maxSteps: 2 },
      3,
      '0.06 s → 2 equal parts of 0.03 s, none longer than 0.03 s. The other 0.04 s of the frame is lost.',
    ],
    [
      { kind: 'fixed', step: 1 / 60 },
      3,
      '0 s in the accumulator + 0.1 s → 6 fixed steps of 0.016667 s, 0 s left in the accumulator.',
    ],
    [
      { kind: 'fixed', step: 0.04 },
      2,
      '0.02 s in the accumulator + 0.1 s → 3 fixed steps of 0.04 s, 0 s left in the accumulator.',
    ],
    [
      { kind: 'fixed', step: 0.02, maxSteps: 3 },
      3,
      '0 s in the accumulator + 0.1 s → 3 fixed steps of 0.02 s, 0 s left in the accumulator. 2 steps more would have been due: 0.04 s is lost.',
    ],
    [
      { kind: 'fixed', step: 0.02, cap: 0.07 },
      2,
      '0.01 s in the accumulator + 0.07 s → 4 fixed steps of 0.02 s, 0 s left in the accumulator. The frame exceeds the cap: 0.03 s is lost.',
    ],
    // At rest: nothing was stepped, and still the accumulator goes on.
    [
      { kind: 'fixed', step: 0.04 },
      10,
      '0.02 s in the accumulator + 0.1 s → 3 fixed steps of 0.04 s, 0 s left in the accumulator.',
    ],
  ] as const)('%j, frame %i', (timestep, row, expected) => {
    expect(words(timestep, row)).toBe(expected)
  })

  test('where the run ends', () => {
    const fall = { scene: 'half-pipe', parameters: { speed: 20 } } as const
    const run = simulate({ ...kicked, ...fall })
    expect(run.outcome.kind).toBe('left-the-track')
    expect(words({ kind: 'variable' }, run.frames, fall)).toBe(
      '1 step of 0.1 s, until the run ended.',
    )
  })

  test('the length of a frame is told without what rounding left of it', () => {
    expect(frameLength(simulate(kicked), 7)).toBe(0.1)
  })
})

describe('what the stopping rule did', () => {
  const words = (experiment: Experiment, row: number) => {
    const resolved = simulate(experiment).experiment
    return traceFrame(experiment, row).flatMap((step) =>
      [
        ...wordsBefore(step, resolved),
        ...step.stretches.flatMap((stretch) => wordsAfter(step, stretch, resolved)),
      ].map(textOf),
    )
  }
  const with_ = (others: Partial<Experiment>): Experiment => ({ ...kicked, ...others })

  test('a stop that was located, and why it stays', () => {
    expect(words(kicked, 6)).toEqual([])
    expect(words(kicked, 7)).toEqual([
      'v reached 0 after 0.087108 s of 0.1 s, found in 2 tries; s = −1.7178 m; it stays, because |drive| 2.5390 ≤ μs press 4.7379 m/s².',
    ])
    expect(words(kicked, 8)).toEqual([])
  })

  test('a stop after which it slides back', () => {
    const [sentence] = words(
      with_({ parameters: { angle: 40, speed: -2 }, frames: { kind: 'steady', fps: 2 } }),
      1,
    )
    expect(sentence).toMatch(
      /^v reached 0 after 0\.\d+ s of 0\.5 s.*it sets off, because \|drive\| 6\.3057 > μs press/,
    )
  })

  test('a clamp, and the look at whether it stays in the next step', () => {
    const clamped = with_({ stopping: 'clamped', integrator: 'semi-implicit-euler' })
    expect(words(clamped, 7)).toEqual([
      'v would have been 0.093817 m/s: set to 0.',
      expect.stringMatching(
        /^s would have been −1\.\d+ m, behind where the step began: set back to −1\.\d+ m\.$/,
      ),
    ])
    expect(words(clamped, 8)).toEqual([
      'The block is at rest: it stays, because |drive| 2.5390 ≤ μs press 4.7379 m/s².',
    ])
  })

  test('nobody: the paper’s block trembles', () => {
    const naive = with_({ stopping: 'naive', integrator: 'semi-implicit-euler' })
    expect(words(naive, 7)[0]).toContain('so it trembles')
  })

  test('a joint, the end of the track, and a step that is no motion any more', () => {
    const slide = with_({
      scene: 'run-out',
      parameters: { length: 0.5 },
      frames: { kind: 'steady', fps: 2 },
      duration: 3,
    })
    expect(
      Array.from({ length: 6 }, (_, i) => words(slide, i + 1))
        .flat()
        .join(),
    ).toMatch(/The block reaches the joint at s = 0\.5 m after/)
    const out = with_({ scene: 'half-pipe', parameters: { speed: 20 } })
    expect(words(out, simulate(out).frames).at(-1)).toContain('the block has left it')
    const wild = with_({
      scene: 'spring',
      parameters: { stiffness: 1000 },
      integrator: 'explicit-euler',
      duration: 60,
    })
    expect(simulate(wild).outcome.kind).toBe('diverged')
    expect(words(wild, simulate(wild).frames).at(-1)).toContain('lost its stability')
  })
})
