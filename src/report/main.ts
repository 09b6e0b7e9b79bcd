import { compareCheckouts } from './against/index.ts'
import { beChild } from './child.ts'
import { measure } from './measure.ts'
import { readReport, writeReport } from './write.ts'
import { terminalText } from './text/terminal.ts'

/**
 * `bench` measures and prints; `report` measures and writes; `redraw` writes anew what follows from the figures that are
 * there. With `--quick`: few rounds, for trying out.
 */
const [command, ...options] = process.argv.slice(2)
const quick = options.includes('--quick')
const tell = (what: string) =>
  process.stderr.write(`${performance.now().toFixed(0).padStart(7)} ms  ${what}\n`)

if (command === 'task') await beChild(options[0]!, options[1]!)
else if (command === 'bench' && options[0] === '--against')
  console.log(await compareCheckouts(options[1]!, tell))
else if (command === 'bench')
  console.log(terminalText({ ...(await measure(quick, tell)), diagrams: [] }))
else if (command === 'redraw') await writeReport(readReport(), tell)
else if (command === 'report') await writeReport(await measure(quick, tell), tell)
else throw new Error(`“${command}” is neither bench nor report nor redraw.`)
