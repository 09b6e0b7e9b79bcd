/** What a column's heading says about the frame times in it. */
export interface Meaning {
  /** 0 for the usual frame time; the higher, the less likely it is what is looked for. */
  readonly rank: number
  /** It holds instants, whose differences are frame times. */
  readonly isClock: boolean
}

const length = (rank: number): Meaning => ({ rank, isClock: false })
const clock: Meaning = { rank: 5, isClock: true }

const meanings: readonly (readonly [RegExp, Meaning])[] = [
  [/^(ms)?betweenpresents$/, length(0)],
  [/^frametimes?$/, length(0)],
  [/^(ms)?betweendisplaychange$|^displayedtime$/, length(4)],
  [/frame.*(start|begin|stamp)/, clock],
  [/(gpu|cpu).*frame.*(time|ms|duration)/, length(3)],
  [/frame.*(time|ms|duration|delta|interval)/, length(1)],
  [/^(ms|delta|deltatime|dt)$/, length(2)],
  [/^(time(stamp|inseconds)?|zeit|temps|tiempo|tempo|elapsed(time)?|cpustarttime)$/, clock],
]

/** What a heading means, whatever its case, blanks, punctuation and unit; undefined where it names no time of frames. */
export function meaningOf(heading: string): Meaning | undefined {
  const letters = heading
    .replace(/[([][^)\]]*[)\]]/g, '')
    .replace(/[_ ](ns|us|µs|μs|ms|s)\s*$/i, '')
    .toLowerCase()
    .replace(/[^a-z]/g, '')
  return meanings.find(([pattern]) => pattern.test(letters))?.[1]
}

/** The columns that tell which process, and which of its windows, a row is about; the first is shown to people. */
export function processColumns(headings: readonly string[]): number[] {
  return [/^(application|processname|process)$/, /^processid$/, /^swapchain(address)?$/]
    .map((pattern) => headings.findIndex((each) => pattern.test(each.toLowerCase().trim())))
    .filter((column) => column >= 0)
}
