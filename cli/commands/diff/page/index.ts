export { diffPage } from '../page.ts';
