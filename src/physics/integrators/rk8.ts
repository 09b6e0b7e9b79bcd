import type { Integrator } from '../integrator.ts'

/**
 * The earlier slopes in each stage, and in the step: the common divisor, then for each slope its index and the
 * whole numbers p and q of its weight p + q√21 (Cooper & Verner, 1972; in this form Hairer, Nørsett & Wanner).
 */
const STAGES: readonly (readonly [number, ...(readonly [number, number, number])[]])[] = [
  [2, [1, 1, 0]],
  [4, [1, 1, 0], [2, 1, 0]],
  [98, [1, 14, 0], [2, -7, -3], [3, 42, 10]],
  [252, [1, 33, 3], [3, 72, 16], [4, 21, -1]],
  [720, [1, 75, 15], [3, 180, 20], [4, -462, 28], [5, 567, -63]],
  [630, [1, 150, -15], [3, -864, 184], [4, 4431, -1015], [5, -4536, 1035], [6, 1134, -234]],
  [126, [1, 9, 0], [5, 14, -3], [6, 26, -6], [7, 14, 0]],
  [1152, [1, 36, 0], [5, 182, -42], [6, 176, 0], [7, -385, -75], [8, 567, 117]],
  [
    17640,
    ...([
      [1, 1260, 0],
      [5, 1960, 0],
      [6, -5864, -1176],
    ] as const),
    ...([
      [7, 18025, 3885],
      [8, -16065, -3465],
      [9, 9504, 2016],
    ] as const),
  ],
  [
    360,
    ...([
      [5, -840, 140],
      [6, -144, 224],
      [7, -1365, -265],
    ] as const),
    ...([
      [8, 1505, 265],
      [9, 224, -224],
      [10, 980, -140],
    ] as const),
  ],
  [180, [1, 9, 0], [8, 49, 0], [9, 64, 0], [10, 49, 0], [11, 9, 0]],
]

/** The weights as numbers, zeros included. */
const shares = STAGES.map(([divisor, ...terms], i) => {
  const row = new Float64Array(i + 1)
  for (const [slope, p, q] of terms) row[slope - 1] = (p + q * Math.sqrt(21)) / divisor
  return row
})

/** A stage's sum of slopes as a formula. */
function sum([divisor, ...terms]: (typeof STAGES)[number], letter: 's' | 'v'): string {
  const written = terms.map(([slope, p, q], i) => {
    const sign = p < 0 ? ' − ' : i > 0 ? ' + ' : ''
    const root = Math.abs(q) === 1 ? '√21' : `${Math.abs(q)}√21`
    const share = q === 0 ? `${p}` : `(${Math.abs(p)} ${p < 0 === q < 0 ? '+' : '−'} ${root})`
    const name = letter === 'v' ? `a${lowered(slope)}` : slope > 1 ? `v${lowered(slope)}` : 'v'
    return `${sign}${share === '1' ? '' : `${share} `}${name}`
  })
  const all = written.join('')
  return `${letter} + ${terms.length > 1 ? `(${all})` : all} Δt/${divisor}`
}

function lowered(n: number): string {
  return `${n}`.replace(/\d/g, (digit) => '₀₁₂₃₄₅₆₇₈₉'[Number(digit)]!)
}

/** The slopes of the stages: ds/dt and dv/dt. */
const speeds = new Float64Array(11)
const accelerations = new Float64Array(11)

/** A Runge–Kutta method of the eighth order in eleven stages (Cooper & Verner, 1972). */
export const rk8 = {
  id: 'rk8',
  label: 'Runge–Kutta 8',
  about: 'Eleven slopes, weighted so that errors up to the eighth power of the step cancel.',
  formula: [
    'a₁ = a(s, v)',
    ...STAGES.slice(0, -1).flatMap((stage, i) => {
      const n = lowered(i + 2)
      return [`v${n} = ${sum(stage, 'v')}`, `s${n} = ${sum(stage, 's')}`, `a${n} = a(s${n}, v${n})`]
    }),
    `s′ = ${sum(STAGES[10]!, 's')}`,
    `v′ = ${sum(STAGES[10]!, 'v')}`,
  ],
  order: 8,
  orderWithSpeed: 8,
  // Where the amplification of the harmonic oscillator reaches 1.
  stability: 3.0014,
  symplectic: false,
  evaluations: { least: 11, most: 11 },
  colour: 7,
  step: (motion) => {
    const { s, v, dt } = motion
    let sHere = s
    let vHere = v
    for (let stage = 0; stage < 11; stage++) {
      speeds[stage] = vHere
      accelerations[stage] = motion.acceleration(sHere, vHere)
      const share = shares[stage]!
      let speed = 0
      let acceleration = 0
      for (let i = 0; i <= stage; i++) {
        speed += share[i]! * speeds[i]!
        acceleration += share[i]! * accelerations[i]!
      }
      sHere = s + speed * dt
      vHere = v + acceleration * dt
    }
    motion.s = sHere
    motion.v = vHere
  },
} as const satisfies Integrator
