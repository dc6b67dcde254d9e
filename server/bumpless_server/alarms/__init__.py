"""What a person must know of: raised by what the server hears, kept until it has both gone and been seen."""
