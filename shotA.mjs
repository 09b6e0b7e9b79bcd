import {open} from './shot15e.mjs'
for (const [w,s] of [[1440,'light'],[768,'dark'],[390,'light']]) {
  const {b,page}=await open(w,s)
  await page.waitForSelector('slide-runner-row')
  await page.locator('select.engines').selectOption({label:'Compare engines'})
  await page.waitForTimeout(900)
  await page.locator('slide-lab').screenshot({path:`/tmp/a-lab-${w}.png`, clip: undefined})
  await page.locator('.runners').screenshot({path:`/tmp/a-run-${w}.png`})
  const f=page.locator('#figure-your-engine'); await f.scrollIntoViewIfNeeded(); await page.waitForSelector('#figure-your-engine slide-figure[live]'); await page.waitForTimeout(500)
  await f.screenshot({path:`/tmp/a-fig-${w}.png`})
  const h = await page.evaluate(()=>{const e=document.querySelector('#figure-your-engine slide-figure .below');return [e.scrollHeight,e.getBoundingClientRect().height,getComputedStyle(e).minHeight]}); console.log(w,h)
  await page.locator('slide-stage').screenshot({path:`/tmp/a-st-${w}.png`});
  const sel=page.locator('#figure-your-engine select'); let mx=0; for (const o of await sel.locator('option').evaluateAll(os=>os.map(o=>o.value))) { await sel.selectOption(o); const v=await page.evaluate(()=>{const e=document.querySelector('#figure-your-engine slide-figure .below');const p=e.querySelectorAll('p.says');const r=p[1].getBoundingClientRect();return [r.bottom-e.getBoundingClientRect().top, e.getBoundingClientRect().height, r.height]}); mx=Math.max(mx,v[0]); if(v[0]+16>v[1]) console.log('over',o,v)} console.log('max bottom',mx);
  await b.close()
}
