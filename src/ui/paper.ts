import { themeChanged } from './theme.ts'

/** Paper is light, whatever the page was switched to. */
export function lightOnPaper(): void {
  const { dataset } = document.documentElement
  let theme: string | undefined
  addEventListener('beforeprint', () => {
    theme = dataset.theme
    dataset.theme = 'light'
    themeChanged()
  })
  addEventListener('afterprint', () => {
    if (theme === undefined) delete dataset.theme
    else dataset.theme = theme
    themeChanged()
  })
}
