import { chromium } from 'playwright-core'
const base = '/work/main/node_modules/.cache/chromium-143.0.4'
const browser = await chromium.launch({ executablePath: base + '/chromium', args: ['--no-sandbox', '--font-render-hinting=none'], env: { ...process.env, LD_LIBRARY_PATH: base + '/al2023/lib', FONTCONFIG_PATH: base + '/fonts' } })
const log = process.argv[2]
for (const [w, scheme] of [[1440, 'light'], [768, 'dark'], [390, 'light'], [390, 'dark'], [1440, 'dark']]) {
  const ctx = await browser.newContext({ viewport: { width: w, height: w < 500 ? 844 : 900 }, colorScheme: scheme, hasTouch: w < 800, reducedMotion: 'reduce' })
  const page = await ctx.newPage()
  page.on('console', (m) => { if (m.type() !== 'log') console.log(w, scheme, m.type(), m.text()) })
  await page.goto('http://localhost:4199/#runners=45/godot;measured', { waitUntil: 'load' })
  await page.waitForTimeout(1500)
  await page.screenshot({ path: `/tmp/look/bad-${w}-${scheme}.png` })
  await page.goto('http://localhost:4199/#runners=45/godot;steady(fps:60,delta:snapped,snapTo:60)', { waitUntil: 'load' })
  await page.reload()
  await page.waitForTimeout(1500)
  const input = page.locator('slide-lab input[type=file]').first()
  if (await input.count()) { await input.setInputFiles(log); await page.waitForTimeout(1500) }
  if (process.argv[3]) { await page.locator('slide-runner-row').nth(1).click({ position: { x: 5, y: 5 } }).catch(() => {}) }
  const el = page.locator('.runners').first()
  await el.scrollIntoViewIfNeeded()
  await el.screenshot({ path: `/tmp/look/log-${w}-${scheme}.png` })
  await ctx.close()
}
await browser.close()
