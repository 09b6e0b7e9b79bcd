import type { Chart } from './chart.ts'

/**
 * Loads what draws charts, uPlot and all: most readers see the lab before its plots.
 *
 * uPlot hands the browser's language to Intl as it is loaded, and a browser without a proper locale calls its language
 * something that Intl refuses (“en-US@posix”). That browser is said to speak English.
 */
export async function loadChart(): Promise<typeof Chart> {
  try {
    new Intl.NumberFormat(navigator.language)
  } catch {
    Object.defineProperty(navigator, 'language', { value: 'en', configurable: true })
  }
  return (await import('./chart.ts')).Chart
}
