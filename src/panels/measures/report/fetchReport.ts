import type { Report } from '../../../report/schema/index.ts'
import { site } from '../../../lab/site.ts'

/**
 * The report that was built with the page, if there is one.
 *
 * @throws Error that says for people why there is none
 */
export async function fetchReport(): Promise<Report> {
  let answer: Response
  const home = site()
  if (home === null) throw new Error('The report is on the lab’s own page, which is not here.')
  try {
    answer = await fetch(new URL('report/report.json', home))
  } catch {
    throw new Error(
      'The report can’t be reached: there is no network, or the page was opened from a file.',
    )
  }
  if (!answer.ok)
    throw new Error('This copy of the page came without a report. “npm run report” measures one.')
  try {
    const report = (await answer.json()) as Partial<Report>
    const { machine, frames, engineTests, notRun, engines } = report
    if (machine && frames && engineTests && notRun && engines) return report as Report
  } catch {
    // It is said below what is wrong with it.
  }
  throw new Error('The report that came with this page is not one that it can read.')
}
