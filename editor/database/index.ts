export { type Database, done, openDatabase } from './database.ts';
