export { type BuiltPack, checkPack, findPack, isUnplayable, packOf, refusedOf, whyRefused } from './pack.ts';
export { GAME, planSite, readGame, type SiteFile, type SiteWords, siteFiles, writeSite } from './site.ts';
