import { chromium } from 'playwright-core'
const base = '/work/main/node_modules/.cache/chromium-143.0.4'
const browser = await chromium.launch({ executablePath: base + '/chromium', args: ['--no-sandbox', '--font-render-hinting=none'], env: { ...process.env, LD_LIBRARY_PATH: base + '/al2023/lib', FONTCONFIG_PATH: base + '/fonts' } })
for (const [n, path, w, h, scheme] of [['a', 'embed.html#runners=45/godot;144/unity-update', 560, 315, 'light'], ['e', 'embed.html', 320, 240, 'dark'], ['f', 'embed.html#scene=half-pipe', 390, 400, 'light'], ['g', 'embed.html', 560, 315, 'light'], ['b', 'embed.html#runners=measured', 560, 315, 'dark'], ['c', 'embed.html#scene=half-pipe&controls=angle,fps,time&hide=exact', 390, 700, 'dark'], ['d', 'embed.html#locked=1', 760, 560, 'light']]) {
  const ctx = await browser.newContext({ viewport: { width: w, height: h }, colorScheme: scheme, reducedMotion: 'reduce' })
  const page = await ctx.newPage()
  await page.goto('http://localhost:4199/' + path, { waitUntil: 'load' })
  await page.waitForTimeout(2500)
  await page.screenshot({ path: `/tmp/look/emb-${n}.png` })
  await ctx.close()
}
await browser.close()
