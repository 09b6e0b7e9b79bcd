import { compareCheckouts } from './against.ts'
import { beChild } from './child.ts'
import { controlled } from './frontiers/controlled.ts'
import { measure } from './measure.ts'
import { readReport, writeReport } from './write.ts'
import { terminalText } from './text/terminal.ts'

/**
 * `bench` measures and prints; `report` measures and writes. `report --redraw` takes no times: it counts evaluations
 * anew, and writes the diagrams and the page again from the numbers of the last report. `bench --against PATH` compares the physics module with that of another
 * checkout. With `--quick`: few rounds, for trying out.
 */
const [command, ...options] = process.argv.slice(2)
const against = options.indexOf('--against')
const quick = options.includes('--quick')
const tell = (what: string) =>
  process.stderr.write(`${performance.now().toFixed(0).padStart(7)} ms  ${what}\n`)

if (command === 'task') await beChild(options[0]!, options[1]!)
else if (command === 'bench' && against >= 0)
  console.log(await compareCheckouts(options[against + 1] ?? '', quick, tell))
else if (command === 'bench')
  console.log(terminalText({ ...(await measure(quick, tell)), diagrams: [] }))
else if (command === 'report')
  await writeReport(
    options.includes('--redraw')
      ? { ...readReport(), controlled: controlled() }
      : await measure(quick, tell),
    tell,
  )
else throw new Error(`“${command}” is neither bench nor report.`)
