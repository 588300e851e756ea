float helper(float value);

float helper(float value)
{
    return value + 1.0F;
}
