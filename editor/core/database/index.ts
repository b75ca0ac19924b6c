export { done, openDatabase } from './database.ts';
