/** What is wrong with a `theme`, in words; '' where it is one, or there is none. */
export function themeProblem(theme: string | null | undefined): string {
  if (!theme || theme === 'light' || theme === 'dark') return ''
  return `“${theme}” is neither light nor dark, so the page’s own is taken`
}
