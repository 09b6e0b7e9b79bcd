import type { Report } from '../schema/index.ts'
import { formatted, markdownTable } from './markdown.ts'
import {
  cheapestWays,
  controlledWays,
  engineErrors,
  engineTimes,
  frameTable,
  measuredOn,
  oddities,
  targetTable,
} from './tables.ts'
import type { Table } from './tables.ts'

/** Where the page stands, from the project's root. */
export const benchmarksFile = 'docs/benchmarks.md'

/** `docs/benchmarks.md`: the whole report as a page, formatted as the project formats it. */
export function benchmarksPage(report: Report): Promise<string> {
  return formatted(text(report), benchmarksFile)
}

function text(report: Report): string {
  const { engines, frontiers, notRun } = report
  const diagram = picturesOf(report)
  return `# Benchmarks

<!-- \`npm run report\` writes this page from what it measures. Edit src/report/text/benchmarks.ts instead. -->

What a step costs, and how far it is from the truth: beside physics engines, beside loops written by hand, and beside an
integrator that chooses its own steps.

${measuredOn(report)}

## How to read this

- A **time** is processor time on the machine above. A **ratio** compares two times from the same round of the same process,
  so it is steadier than the times themselves. **Evaluations** of the acceleration are the same on every machine.
- A game calls \`run.frame\` once a step, so that is what the tables time. The engines and the handwritten loops are also called
  once a step.
- **Alone** is a process that runs one scene with one method. **After everything else** is a process that has already run all
  scenes, methods, rules and policies, so that the JavaScript engine has seen every type of call.

## A step beside physics engines

The engines find collisions between any number of bodies that rotate, and solve for the contacts between them. This project moves
one block that can't leave its track. A game that needs collisions needs an engine. The tables say what the engine costs, and how
far it ends from the true motion of this one block.

${diagram('engines-time.svg')}

${titled(engineTimes(report))}

${diagram('engines-error.svg')}

${titled(engineErrors(report))}

**Anomalies**

${bullets(oddities(report))}

## A step beside a handwritten loop

A handwritten loop is what you would write for one scene and one method, with the duties of \`run.frame\`: it locates stops, ends
at the end of the track, and adds up heat and time. All of them are in \`src/report/handwritten\`.

${titled(frameTable(report))}

## Speed against error

Each point of a diagram is one method at one step length. Down is less error and left is less cost, so of two curves the one
further to the lower left is the better choice.

odex is an extrapolation method that takes a few long steps a second. To draw a picture at every frame it would have to
interpolate, which is not counted here. On the ramp it has to get across the instant at which friction turns round; this project
locates that instant.

${frontiers.flatMap(({ id }) => [diagram(`${id}-time.svg`), diagram(`${id}-evaluations.svg`)]).join('\n\n')}

${titled(cheapestWays(report))}

odex chooses its steps, and so does the policy *to tolerance*. Here they meet, each at whatever tolerance leaves that error; ours
with velocity Verlet, Runge–Kutta 4 and Runge–Kutta 8, in frames of half a second, with every try and every doubled step counted.

${titled(controlledWays(report))}

${controlledWords(report)}

## Targets

${table(targetTable(report))}

## How each is set up

${bullets(engines.map(({ label, setup }) => `**${label}**: ${setup}`))}

## What did not run

${
  notRun.length === 0
    ? 'Everything ran.'
    : bullets(notRun.map(({ what, why }) => `**${what}**: ${why}`))
}

## Measure it yourself

- \`npm run bench\` measures all of this and prints it; with \`-- --quick\`, in half a minute.
- \`npm run report\` also writes this page and \`public/report\`, where \`report.json\` holds every number. A test compares the page
  with those numbers. With \`-- --redraw\`, it writes the page and the diagrams again without measuring.
- \`npm run bench -- --against ../other\` compares the processor time of this checkout's physics with another checkout's.
`
}

/** Who is ahead where steps are chosen, and why. */
function controlledWords({ controlled }: Report): string {
  const behind = controlled.filter(({ at }) =>
    at.some(({ ours, odex }) => odex !== null && (!ours || odex < ours.evaluations)),
  )
  const where = behind.map(({ label }) => label.toLowerCase()).join(' and ')
  const lost =
    behind.length === 0
      ? 'odex is ahead nowhere.'
      : `odex is ahead in places: ${where}. On a smooth motion it raises its order with its step, and each of its estimates is a by-product of the step. A doubled step takes three steps of one fixed order for two that are kept, and keeps the error *for each second* where odex keeps it for each step.`
  return `${lost} Where friction turns round or the track changes its bend, odex has to find the jump by refusing steps until they are short; ours locates it, and goes on from there in long ones.`
}

/** A diagram of the report as an image below its title, by its file's name. */
function picturesOf({ diagrams }: Report): (file: string) => string {
  return (file) => {
    const { title, description } = diagrams.find((each) => each.file === file)!
    return `**${title}**\n\n![${description}](../public/report/${file})`
  }
}

function titled(found: Table): string {
  return `**${found.title}**\n\n${table(found)}`
}

function table({ head, rows }: Table): string {
  return markdownTable(head, rows)
}

function bullets(lines: readonly string[]): string {
  return lines.map((line) => `- ${line}`).join('\n')
}
