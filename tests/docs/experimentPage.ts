import { defaults, integrators, scenes, stoppings, timesteps } from '../../src/physics/index.ts'
import { frameClocks, limits, measuring } from '../../src/physics/index.ts'
import type { NumberOption, Option, Scene } from '../../src/physics/index.ts'

/* docs/experiment.md: what an experiment can say, read off the lists of src/physics. */

/** The page, not yet formatted. */
export function experimentPage(): string {
  return `# Experiments

<!-- \`npm run docs\` writes this page from the lists in src/physics. Edit tests/docs/experimentPage.ts instead. -->

An experiment is a plain JSON value that determines a run. The module, the elements, an address and a preset all take the same
value:

\`\`\`json
{
  "scene": "ramp",
  "parameters": { "angle": 15, "muStatic": 0.5, "muKinetic": 0.5, "speed": -5 },
  "integrator": "rk4",
  "stopping": "located",
  "timestep": { "kind": "fixed", "step": 0.02 },
  "frames": { "kind": "jitter", "fps": 60, "amount": 0.3, "seed": 1 },
  "duration": 2
}
\`\`\`

Only \`scene\` must be given. Values are in SI units, angles in degrees. \`parseExperiment\` checks a value and refuses it with a
message that names every problem: each wrong path, what was given, and what is allowed.

## Scenes

${table(
  ['scene', 'what it is', 'parameters, and their defaults', 'duration'],
  (scenes as readonly Scene[]).map(({ id, about, parameters, duration }) => [
    `\`${id}\``,
    about,
    Object.entries(parameters)
      .map(([name, { initial }]) => `\`${name}\` ${initial}`)
      .join(', '),
    `${duration} s`,
  ]),
)}

## Parameters

${table(['parameter', 'what it is', 'in formulas', 'unit', 'valid'], parameterRows())}

μs may not be smaller than μk. If only one of them is given, the other follows it where it must.

## Integrators

Default: \`${defaults.integrator}\`. On an oscillation of angular frequency ω, a step Δt stays bounded while ωΔt is below the
stability limit.

${table(
  ['integrator', 'name', 'order', 'stability limit', 'symplectic', 'evaluations a step'],
  integrators.map(({ id, label, order, stability, symplectic, evaluations: { least, most } }) => [
    `\`${id}\``,
    label,
    String(order),
    stability === 0 ? 'never stable' : stability === Infinity ? 'always stable' : plain(stability),
    symplectic ? 'yes' : 'no',
    least === most ? String(most) : `${least} to ${most}`,
  ]),
)}

## Stopping rules

Default: \`${defaults.stopping}\`.

${table(
  ['stopping', 'what it does'],
  stoppings.map(({ id, about }) => [`\`${id}\``, about]),
)}

## Timestep policies

Default: \`${defaults.timestep.kind}\`.

${choices(timesteps)}

## Frame clocks

Default: \`${defaults.frames.kind}\`, at ${defaults.frames.fps} fps.

${choices(frameClocks)}

How the game measures its frames is an option of every clock. Frames are shown for as long as the clock says; the game moves by
its delta time. Default: \`exact\`.

${table(
  ['option', 'values'],
  Object.entries(measuring).map(([name, option]) => [
    `\`${name}\``,
    optionWords([name, option]).replace(/^\S+ /, ''),
  ]),
)}

- \`rounded\`: to whole milliseconds.
- \`mean\`: the mean of the last \`meanOf\` frames, or of all while there are fewer.
- \`snapped\`: the nearest whole number of refreshes of a display at \`snapTo\`, and one at the least.
- \`late\`: the length of the frame before; of the first frame, 0.

## Slow motion

\`timeScale\`, from ${plain(limits.timeScale.min)} to ${plain(limits.timeScale.max)}, is how fast the game’s time goes. Default: ${defaults.timeScale}. At 0.1 a frame moves the game by a tenth of
its delta time, and what is shown after 10 s is compared with the true motion after 1 s.

## Limits

A run lasts at most ${plain(limits.duration)} s, and takes at most ${plain(limits.frames)} frames, ${plain(limits.steps)} steps and ${plain(limits.evaluations)} evaluations of the acceleration.
`
}

/** A row for each parameter of any scene, in the order in which the scenes bring them. */
function parameterRows(): string[][] {
  const found = new Map<string, NumberOption>()
  for (const { parameters } of scenes as readonly Scene[])
    for (const [name, option] of Object.entries(parameters))
      if (!found.has(name)) found.set(name, option)
  return [...found].map(([name, option]) => [
    `\`${name}\``,
    option.label,
    option.symbol,
    option.unit || '–',
    `${plain(option.min)} to ${plain(option.max)}`,
  ])
}

interface Choice {
  readonly id: string
  readonly about: string
  readonly options: Readonly<Record<string, Option>>
}

function choices(list: readonly Choice[]): string {
  return table(
    ['kind', 'what it does', 'options'],
    list.map(({ id, about, options }) => [
      `\`${id}\``,
      about,
      Object.entries(options).map(optionWords).join('; ') || '–',
    ]),
  )
}

function optionWords([name, option]: [string, Option]): string {
  const optional = option.optional || option.sparse ? ', optional' : ''
  if (option.type === 'choice')
    return `\`${name}\`: ${option.choices.map((choice) => `\`${choice}\``).join(', ')}${optional}`
  const unit = option.unit ? ` ${option.unit}` : ''
  const range = `${plain(option.min)} to ${plain(option.max)}${unit}`
  return option.type === 'list'
    ? `\`${name}\`: 1 to ${plain(option.maxLength)} numbers, each ${range}${optional}`
    : `\`${name}\`: ${range}${optional}`
}

function table(head: readonly string[], rows: readonly (readonly string[])[]): string {
  const line = (cells: readonly string[]) => `| ${cells.join(' | ')} |`
  return [line(head), line(head.map(() => '---')), ...rows.map(line)].join('\n')
}

/** A number as people write it: −1 000 000 000, 10⁻⁶, 2.83. */
function plain(value: number): string {
  const size = Math.abs(value)
  const sign = value < 0 ? '−' : ''
  const power = Math.round(Math.log10(size))
  if (size !== 0 && (size < 1e-3 || size >= 1e5) && Math.abs(size / 10 ** power - 1) < 1e-12)
    return `${sign}10${String(power).replace(/./g, (c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(c)]!))}`
  const digits = Number.isInteger(size) ? String(size) : String(Number(size.toPrecision(3)))
  return sign + digits.replace(/\B(?=(\d{3})+$)/g, '\u202f')
}
